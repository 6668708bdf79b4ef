#include "ui/results/figures_model.h"

#include "ui/text/unit_text.h"

#include <algorithm>

namespace furrow {

namespace {

/// Why land is missed: out of the machine's reach, or left.
QString missedHint(const Plan& plan) {
    const AuditReport& audit = plan.audit;
    if (!audit.missed || audit.missed->si() < 0.5) {
        return FiguresModel::tr("Land that is not worked");
    }
    const Area beyond = std::max(*audit.missed - audit.left, Area{});
    return FiguresModel::tr("%1 cannot be reached by the implement, mostly in corners; %2 could be.")
        .arg(areaText(beyond), areaText(audit.left));
}

}  // namespace

void FiguresModel::show(const Plan* plan) {
    std::vector<Figure> figures;
    if (plan != nullptr) {
        const Length path = plan->path.length();
        const Length working = plan->path.workedLength();
        const Length turning = path - working;
        const auto share = [path](Length part) { return path.si() > 0.0 ? part / path : 0.0; };
        const auto shareOfField = [plan](const std::optional<Area>& part) {
            return part && plan->audit.workable.si() > 0.0 ? *part / plan->audit.workable : 0.0;
        };
        const QString notMeasured = QStringLiteral("–");
        const Area mainland = area(plan->headland.mainland);
        figures = {
            {tr("Area"), areaText(plan->field().area()), tr("Of the field, holes and obstacles taken out")},
            {tr("Inside the headland"),
             inOneLine({areaText(mainland), percentText(plan->headland.mainlandRatio)}),
             tr("What is left inside the headland")},
            {tr("Swaths"), numberText(static_cast<double>(plan->swaths.swaths.size()), 0), {}},
            {tr("Path"), lengthText(path), tr("Everything that is driven")},
            {tr("Working"), inOneLine({lengthText(working), percentText(share(working))}), {}},
            {tr("Turning"), inOneLine({lengthText(turning), percentText(share(turning))}), {}},
            {tr("Time"), durationText(plan->path.duration()), {}},
            {tr("Covered"),
             plan->audit.coveredShare ? percentText(*plan->audit.coveredShare, 1) : notMeasured,
             tr("Share of the field that is worked, measured on the finished path")},
            {tr("Overlap"),
             plan->audit.overlap ? percentText(shareOfField(plan->audit.overlap), 1) : notMeasured,
             tr("Share of the field that is worked twice")},
            {tr("Missed"), plan->audit.missed ? areaText(*plan->audit.missed) : notMeasured,
             missedHint(*plan)},
            {tr("Outside the field"), plan->audit.outside ? areaText(*plan->audit.outside) : notMeasured,
             tr("Ground outside that the machine or its implement drives over")},
        };
    }
    const bool sameLength = figures.size() == figures_.size();
    if (!sameLength) {
        beginResetModel();
    }
    figures_ = std::move(figures);
    if (!sameLength) {
        endResetModel();
    } else if (!figures_.empty()) {
        emit dataChanged(index(0), index(rowCount() - 1));
    }
}

int FiguresModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(figures_.size());
}

QVariant FiguresModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Figure& figure = figures_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
        case LabelRole: return figure.label;
        case ValueRole: return figure.value;
        case HintRole: return figure.hint;
        default: return {};
    }
}

QHash<int, QByteArray> FiguresModel::roleNames() const {
    return {{LabelRole, "label"}, {ValueRole, "value"}, {HintRole, "hint"}};
}

}  // namespace furrow
