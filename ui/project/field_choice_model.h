#pragma once

#include "planner/field/field.h"

#include <QtQml/qqmlregistration.h>
#include <QAbstractListModel>
#include <QList>
#include <QPointF>

namespace furrow {

/// The fields of a file, for the user to pick one.
class FieldChoiceModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(int count READ count NOTIFY countChanged FINAL)

public:
    enum Role { NameRole = Qt::UserRole + 1, AreaRole, OutlineRole };

    explicit FieldChoiceModel(QObject* parent = nullptr);

    void show(std::vector<FieldSource> fields);
    int count() const { return static_cast<int>(fields_.size()); }
    const FieldSource& field(int row) const { return fields_[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

signals:
    void countChanged();

private:
    std::vector<FieldSource> fields_;
};

}  // namespace furrow
