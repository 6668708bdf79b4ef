#include "ui/results/findings_model.h"

#include "planner/path/blocking.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/shown_value.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>

namespace furrow {

namespace {

/// "Passes: 3"; empty for a change that cannot be read.
QString changeText(const SettingChange& change) {
    const auto parameter = findParameter(change.key);
    Settings settings;
    if (!parameter || !settings.setText(**parameter, change.value)) {
        return {};
    }
    return FindingsModel::tr("%1: %2").arg(shown((*parameter)->name),
                                           shown(shownValue(**parameter, settings.value(**parameter))));
}

}  // namespace

static_assert(static_cast<int>(Weight::Blocks) == FindingsModel::Blocks &&
              static_cast<int>(Weight::Look) == FindingsModel::Look &&
              static_cast<int>(Weight::Information) == FindingsModel::Information);

FindingsModel::FindingsModel(QObject* parent) : QAbstractListModel{parent} {
    connect(&Display::instance(), &Display::changed, this, [this] {
        if (rowCount() > 0) {
            emit dataChanged(index(0), index(rowCount() - 1));
        }
        emit outcomeChanged();
    });
}

void FindingsModel::show(const std::vector<Finding>& findings, const std::vector<QGeoCoordinate>& places) {
    if (applied_ && !applied_->after) {
        applied_->after = blockingCount(findings);
        emit outcomeChanged();
    }
    if (findings == findings_ && places == places_) {
        return;
    }
    // While a value is dragged the list often keeps its length: no reason to lose the scroll position.
    const bool sameLength = shownCount(findings.size()) == rowCount();
    if (!sameLength) {
        beginResetModel();
    }
    findings_ = findings;
    places_ = places;
    if (!sameLength) {
        endResetModel();
    } else if (rowCount() > 0) {
        emit dataChanged(index(0), index(rowCount() - 1));
    }
    emit countChanged();
}

void FindingsModel::setAll(bool all) {
    if (all == all_) {
        return;
    }
    beginResetModel();
    all_ = all;
    endResetModel();
    emit allChanged();
}

int FindingsModel::toLookAt() const {
    return static_cast<int>(std::ranges::count_if(
        findings_, [](const Finding& finding) { return weightOf(finding) != Weight::Information; }));
}

int FindingsModel::shownCount(std::size_t findings) const {
    return all_ ? static_cast<int>(findings) : std::min(static_cast<int>(findings), few());
}

int FindingsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : shownCount(findings_.size());
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Finding& finding = findings_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case NumberRole: return index.row() + 1;
        case Qt::DisplayRole:
        case TextRole: return shown(finding.text);
        case SuggestionRole: return shown(finding.suggestion);
        case WeightRole: return static_cast<int>(weightOf(finding));
        case BeginsInformationRole:
            return weightOf(finding) == Weight::Information &&
                   (index.row() == 0 ||
                    weightOf(findings_[static_cast<std::size_t>(index.row()) - 1]) != Weight::Information);
        case PlaceRole: return QVariant::fromValue(placeOf(index.row()));
        case ChangeRole: return finding.change ? changeText(*finding.change) : QString{};
        default: return {};
    }
}

QHash<int, QByteArray> FindingsModel::roleNames() const {
    return {{NumberRole, "number"},
            {TextRole, "finding"},
            {SuggestionRole, "suggestion"},
            {WeightRole, "weight"},
            {PlaceRole, "place"},
            {ChangeRole, "change"},
            {BeginsInformationRole, "beginsInformation"}};
}

QString FindingsModel::outcome() const {
    if (!applied_ || !applied_->after) {
        return {};
    }
    const auto problems = [](std::ptrdiff_t count) {
        return count == 0 ? tr("no problems") : tr("%n problem(s)", nullptr, static_cast<int>(count));
    };
    return tr("%1. Before: %2. Now: %3.")
        .arg(changeText(applied_->change), problems(applied_->before), problems(*applied_->after));
}

void FindingsModel::apply(int row) {
    const auto index = static_cast<std::size_t>(row);
    if (row < 0 || index >= findings_.size() || !findings_[index].change) {
        return;
    }
    const SettingChange change = *findings_[index].change;
    applied_ = Applied{.change = change, .before = blockingCount(findings_), .after = {}};
    emit outcomeChanged();
    emit changeRequested(change);
}

void FindingsModel::forgetOutcome() {
    if (applied_) {
        applied_.reset();
        emit outcomeChanged();
    }
}

QStringList FindingsModel::texts() const {
    QStringList texts;
    for (const Finding& finding : findings_) {
        texts << shown(finding.text);
    }
    return texts;
}

QGeoCoordinate FindingsModel::placeOf(int row) const {
    return row >= 0 && row < static_cast<int>(places_.size()) ? places_[static_cast<std::size_t>(row)]
                                                              : QGeoCoordinate{};
}

}  // namespace furrow
