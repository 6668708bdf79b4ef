#include "ui/project/field_choice_model.h"

#include "planner/io/import/boundary_import.h"
#include "ui/project/field_outline.h"
#include "ui/text/display.h"
#include "ui/text/unit_text.h"

namespace furrow {

FieldChoiceModel::FieldChoiceModel(QObject* parent) : QAbstractListModel{parent} {
    connect(&Display::instance(), &Display::changed, this, [this] {
        if (rowCount() > 0) {
            emit dataChanged(index(0), index(rowCount() - 1));
        }
    });
}

void FieldChoiceModel::show(std::vector<FieldSource> fields) {
    beginResetModel();
    fields_ = std::move(fields);
    endResetModel();
    emit countChanged();
}

int FieldChoiceModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : count();
}

QVariant FieldChoiceModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
        case NameRole: return fromStd(field(index.row()).name);
        case AreaRole: return areaText(areaOf(field(index.row())));
        case OutlineRole: return QVariant::fromValue(fieldOutline(field(index.row())));
        default: return {};
    }
}

QHash<int, QByteArray> FieldChoiceModel::roleNames() const {
    return {{NameRole, "name"}, {AreaRole, "area"}, {OutlineRole, "outline"}};
}

}  // namespace furrow
