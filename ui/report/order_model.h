#pragma once

#include "planner/project/work_order.h"
#include "ui/project/document.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QStringList>

namespace furrow {

/// What the current plan is handed out with, as lines to fill in. What is typed is kept in the project, as a
/// step of undo.
class OrderModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// An index into `statusNames`.
    Q_PROPERTY(int status READ status WRITE setStatus NOTIFY changed FINAL)
    Q_PROPERTY(QStringList statusNames READ statusNames NOTIFY changed FINAL)

public:
    enum Role { KeyRole = Qt::UserRole + 1, NameRole, TextRole, HalfRole };

    explicit OrderModel(Document& document, QObject* parent = nullptr);

    const WorkOrder& order() const { return document_.project()->plan().order; }
    int status() const { return static_cast<int>(order().status); }
    void setStatus(int status);
    QStringList statusNames() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// Whether a text can stand in a line: amounts have to be numbers; empty is nothing said.
    Q_INVOKABLE bool accepts(int row, const QString& text) const;
    Q_INVOKABLE void setText(int row, const QString& text);

signals:
    void changed();

private:
    void follow();
    void change(WorkOrder order, const char* what);

    Document& document_;
    WorkOrder shown_;
};

}  // namespace furrow
