#include "ui/best/choice_table_model.h"

#include "planner/plan/best_plan.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace furrow {

namespace {

constexpr Duration kSame = seconds(0.5);
// More rows would push the buttons off a small window.
constexpr std::size_t kMostOthers = 8;

QString choiceName(std::string_view id) {
    const auto choices = planChoices();
    return shown(std::ranges::find(choices, id, &PlanChoice::id)->name);
}

bool isTaken(const TriedChoice& tried) {
    return tried.worth == TriedChoice::Worth::Taken;
}

Duration size(Duration difference) {
    return seconds(std::abs(difference.si()));
}

bool takesTheSameTime(const TriedChoice& tried) {
    return !isTaken(tried) && size(tried.difference) < kSame;
}

}  // namespace

void ChoiceTableModel::show(const ChoiceTable& table) {
    beginResetModel();
    rows_.clear();
    std::ranges::copy_if(table.tried, std::back_inserter(rows_),
                         [](const TriedChoice& tried) { return tried.worth != TriedChoice::Worth::Behind; });
    std::ranges::stable_sort(rows_, [](const TriedChoice& a, const TriedChoice& b) {
        return isTaken(a) != isTaken(b) ? isTaken(a)
               : isTaken(a)             ? a.difference > b.difference
                                        : a.difference < b.difference;
    });
    const auto taken = static_cast<std::size_t>(std::ranges::count_if(rows_, isTaken));
    rows_.resize(std::min(rows_.size(), taken + kMostOthers));
    behind_ = static_cast<int>(table.tried.size() - rows_.size());
    most_ = {};
    for (const TriedChoice& row : rows_) {
        most_ = std::max(most_, size(row.difference));
    }
    endResetModel();
    emit tableChanged();
}

int ChoiceTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant ChoiceTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const TriedChoice& row = rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case ChoiceRole: return choiceName(row.choice);
        case Qt::DisplayRole:
        case TextRole: return furrow::shown(row.text);
        case WorthRole: {
            if (isTaken(row)) {
                return row.difference > Duration{} ? tr("saves %1").arg(exactDurationText(row.difference))
                                                   : tr("mends the plan");
            }
            if (takesTheSameTime(row)) {
                return tr("the same time");
            }
            return row.difference > Duration{} ? tr("%1 slower").arg(exactDurationText(row.difference))
                                               : tr("%1 quicker").arg(exactDurationText(-row.difference));
        }
        case TakenRole: return isTaken(row);
        case ShareRole:
            return most_ > Duration{} && !takesTheSameTime(row) ? size(row.difference) / most_ : 0.0;
        default: return {};
    }
}

QHash<int, QByteArray> ChoiceTableModel::roleNames() const {
    return {{ChoiceRole, "choice"},
            {TextRole, "said"},
            {WorthRole, "worth"},
            {TakenRole, "taken"},
            {ShareRole, "share"}};
}

}  // namespace furrow
