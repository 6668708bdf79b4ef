#include "ui/results/findings_model.h"

#include "planner/path/blocking.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>

namespace furrow {

FindingsModel::FindingsModel(QObject* parent) : QAbstractListModel{parent} {
    connect(&Display::instance(), &Display::changed, this, [this] {
        if (rowCount() > 0) {
            emit dataChanged(index(0), index(rowCount() - 1));
        }
    });
}

void FindingsModel::show(const std::vector<Finding>& findings, const std::vector<QGeoCoordinate>& places) {
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
        case BlockingRole: return isBlocking(finding);
        case PlaceRole: return QVariant::fromValue(placeOf(index.row()));
        default: return {};
    }
}

QHash<int, QByteArray> FindingsModel::roleNames() const {
    return {{NumberRole, "number"},
            {TextRole, "finding"},
            {SuggestionRole, "suggestion"},
            {BlockingRole, "blocking"},
            {PlaceRole, "place"}};
}

QGeoCoordinate FindingsModel::placeOf(int row) const {
    return row >= 0 && row < static_cast<int>(places_.size()) ? places_[static_cast<std::size_t>(row)]
                                                              : QGeoCoordinate{};
}

}  // namespace furrow
