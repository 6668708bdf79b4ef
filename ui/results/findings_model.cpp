#include "ui/results/findings_model.h"

#include "planner/path/blocking.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/shown_value.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/setting_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace furrow {

namespace {

struct ShownChange {
    const Parameter* parameter = nullptr;
    QString value;
};

/// Empty for a change that cannot be read.
std::optional<ShownChange> shownChange(const SettingChange& change) {
    const auto parameter = findParameter(change.key);
    Settings settings;
    if (!parameter || !settings.setText(**parameter, change.value)) {
        return std::nullopt;
    }
    return ShownChange{.parameter = *parameter,
                       .value = shown(shownValue(**parameter, settings.value(**parameter)))};
}

/// "Passes: 3", for the button of a finding.
QString changeText(const SettingChange& change) {
    const auto to = shownChange(change);
    return to ? FindingsModel::tr("%1: %2").arg(shown(to->parameter->name), to->value) : QString{};
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
    std::vector<Row> rows = rowsOf(findings);
    const bool sameLength = shownCount(rows.size()) == rowCount();
    if (!sameLength) {
        beginResetModel();
    }
    findings_ = findings;
    rows_ = std::move(rows);
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

int FindingsModel::blocking() const {
    return static_cast<int>(std::ranges::count_if(
        findings_, [](const Finding& finding) { return weightOf(finding) == Weight::Blocks; }));
}

int FindingsModel::toLookAt() const {
    return static_cast<int>(std::ranges::count_if(
        findings_, [](const Finding& finding) { return weightOf(finding) != Weight::Information; }));
}

bool FindingsModel::Row::isOf(const Finding& finding, const std::vector<Finding>& all) const {
    const Finding& first = all[findings.front()];
    return kindId(first) == kindId(finding) && weightOf(first) == weightOf(finding);
}

std::vector<FindingsModel::Row> FindingsModel::rowsOf(const std::vector<Finding>& findings) const {
    std::vector<Row> kinds;
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const auto known =
            std::ranges::find_if(kinds, [&](const Row& row) { return row.isOf(findings[i], findings); });
        if (known == kinds.end()) {
            kinds.push_back({.findings = {i}});
        } else {
            known->findings.push_back(i);
        }
    }
    std::vector<Row> rows;
    for (Row& kind : kinds) {
        if (kind.findings.size() >= kMany) {
            // While a value is dragged the same one stays in view.
            const auto before = std::ranges::find_if(
                rows_, [&](const Row& row) { return row.isOf(findings[kind.findings.front()], findings_); });
            kind.at = before == rows_.end() ? 0 : std::min(before->at, kind.findings.size() - 1);
            rows.push_back(std::move(kind));
            continue;
        }
        for (const std::size_t i : kind.findings) {
            rows.push_back({.findings = {i}});
        }
    }
    std::ranges::stable_sort(rows, {}, [](const Row& row) { return row.findings.front(); });
    return rows;
}

int FindingsModel::shownCount(std::size_t rows) const {
    return all_ ? static_cast<int>(rows) : std::min(static_cast<int>(rows), few());
}

int FindingsModel::rowOf(int finding) const {
    const auto found = std::ranges::find_if(rows_, [finding](const Row& row) {
        return finding >= 0 && std::ranges::contains(row.findings, static_cast<std::size_t>(finding));
    });
    return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

void FindingsModel::bringForward(int finding) {
    const int at = rowOf(finding);
    if (at < 0) {
        return;
    }
    Row& row = rows_[static_cast<std::size_t>(at)];
    const auto place = std::ranges::find(row.findings, static_cast<std::size_t>(finding));
    const auto next = static_cast<std::size_t>(place - row.findings.begin());
    if (std::exchange(row.at, next) != next && at < rowCount()) {
        emit dataChanged(index(at), index(at));
    }
}

int FindingsModel::nextOfKind(int finding, int by) const {
    const auto all = static_cast<std::ptrdiff_t>(findings_.size());
    if (finding < 0 || finding >= all || by == 0) {
        return all == 0 ? -1 : by > 0 ? 0 : static_cast<int>(all - 1);
    }
    const Row kind{.findings = {static_cast<std::size_t>(finding)}};
    std::ptrdiff_t next = finding;
    do {
        next = (next + (by > 0 ? 1 : all - 1)) % all;
    } while (!kind.isOf(findings_[static_cast<std::size_t>(next)], findings_));
    return static_cast<int>(next);
}

int FindingsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : shownCount(rows_.size());
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    const Finding& finding = shownIn(row);
    const auto number = static_cast<int>(row.findings[row.at]);
    switch (role) {
        case NumberRole: return number + 1;
        case FindingRole: return number;
        case PlaceInKindRole: return static_cast<int>(row.at) + 1;
        case KindCountRole: return static_cast<int>(row.findings.size());
        case Qt::DisplayRole:
        case TextRole: return shown(finding.text);
        case SuggestionRole: return shown(finding.suggestion);
        case WeightRole: return static_cast<int>(weightOf(finding));
        case BeginsInformationRole:
            return weightOf(finding) == Weight::Information &&
                   (index.row() == 0 || weightOf(shownIn(rows_[static_cast<std::size_t>(index.row()) - 1])) !=
                                            Weight::Information);
        case PlaceRole: return QVariant::fromValue(placeOf(number));
        case ChangeRole: return finding.change ? changeText(*finding.change) : QString{};
        default: return {};
    }
}

QHash<int, QByteArray> FindingsModel::roleNames() const {
    return {{NumberRole, "number"},
            {FindingRole, "findingIndex"},
            {PlaceInKindRole, "placeInKind"},
            {KindCountRole, "kindCount"},
            {TextRole, "finding"},
            {SuggestionRole, "suggestion"},
            {WeightRole, "weight"},
            {PlaceRole, "place"},
            {ChangeRole, "change"},
            {BeginsInformationRole, "beginsInformation"}};
}

QString FindingsModel::outcome() const {
    const auto to = applied_ && applied_->after ? shownChange(applied_->change) : std::nullopt;
    if (!to) {
        return {};
    }
    const auto problems = [](std::ptrdiff_t count) {
        return count == 0 ? tr("no problems") : tr("%n problem(s)", nullptr, static_cast<int>(count));
    };
    return tr("%1 → %2. Before: %3. Now: %4.")
        .arg(settingName(*to->parameter), to->value, problems(applied_->before), problems(*applied_->after));
}

void FindingsModel::apply(int finding) {
    const auto index = static_cast<std::size_t>(finding);
    if (finding < 0 || index >= findings_.size() || !findings_[index].change) {
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

QGeoCoordinate FindingsModel::placeOf(int finding) const {
    return finding >= 0 && finding < static_cast<int>(places_.size())
               ? places_[static_cast<std::size_t>(finding)]
               : QGeoCoordinate{};
}

}  // namespace furrow
