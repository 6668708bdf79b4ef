#pragma once

#include "planner/project/project.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QList>
#include <QPointF>

namespace furrow {

/// The projects that were opened or saved last, the latest first, each with the outline of its field. Kept in
/// a file; those that are gone are not shown.
class RecentFiles : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role { PathRole = Qt::UserRole + 1, NameRole, FolderRole, FieldsRole, OutlineRole };

    explicit RecentFiles(QObject* parent = nullptr);

    /// Where the list is kept; without a place it lasts as long as the program.
    void keepIn(const QString& file);
    void add(const QString& path, const Project& project);
    Q_INVOKABLE void clear();

    int count() const { return static_cast<int>(entries_.size()); }
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    struct Entry {
        QString path;
        int fields = 0;
        QList<QPointF> outline;
    };
    void save() const;

    QString file_;
    QList<Entry> entries_;
};

}  // namespace furrow
