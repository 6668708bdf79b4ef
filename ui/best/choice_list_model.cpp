#include "ui/best/choice_list_model.h"

#include "ui/text/message_text.h"

namespace furrow {

ChoiceListModel::ChoiceListModel(QObject* parent) : QAbstractListModel{parent} {
    begin({});
}

void ChoiceListModel::begin(const Settings& settings) {
    beginResetModel();
    rows_.clear();
    for (const PlanChoice& choice : planChoices()) {
        const bool given = isGiven(choice, settings);
        rows_.push_back({.choice = choice, .given = given, .free = !given});
    }
    endResetModel();
}

std::vector<std::string_view> ChoiceListModel::kept() const {
    std::vector<std::string_view> ids;
    for (const Row& row : rows_) {
        if (!row.free) {
            ids.push_back(row.choice.id);
        }
    }
    return ids;
}

int ChoiceListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant ChoiceListModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case NameRole: return shown(row.choice.name);
        case FreeRole: return row.free;
        case GivenRole: return row.given;
        default: return {};
    }
}

QHash<int, QByteArray> ChoiceListModel::roleNames() const {
    return {{NameRole, "name"}, {FreeRole, "free"}, {GivenRole, "given"}};
}

void ChoiceListModel::setFree(int row, bool free) {
    if (row < 0 || row >= rowCount() || rows_[static_cast<std::size_t>(row)].free == free) {
        return;
    }
    rows_[static_cast<std::size_t>(row)].free = free;
    emit dataChanged(index(row), index(row), {FreeRole});
}

}  // namespace furrow
