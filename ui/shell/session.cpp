#include "ui/shell/session.h"

#include "ui/text/display.h"

#include <QDir>

namespace furrow {

Session::Session(QObject* parent) : QObject{parent} {
    connect(&opener_, &FieldOpener::imageryFound, &imagery_, &ImageryModel::add);
    connect(&fieldFromTrack_, &FieldFromTrack::layRequested, &driven_, &DrivenTrack::layRecording);
    connect(&shown_, &ShownPlan::planChanged, this, &Session::showResults);
    connect(&planning_, &Planning::stateChanged, this, &Session::offerExport);
    connect(&findings_, &FindingsModel::changeRequested, &planning_, &Planning::apply);
    const auto keepPlans = [this](const std::vector<FieldsExported::Made>& plans) {
        for (const FieldsExported::Made& made : plans) {
            farmPlans_.keep(*made.of.field, made.of.wanted, made.plan);
        }
    };
    connect(&exporter_, &ExportModel::planned, this, keepPlans);
    connect(&printing_, &Printing::planned, this, keepPlans);
    connect(&Display::instance(), &Display::changed, this, &Session::showResults);
    showResults();
    offerExport();
}

void Session::keepIn(const QString& folder) {
    const QDir place{folder};
    files_.keepIn(place.filePath(QStringLiteral("history")));
    farmPlans_.keepIn(place.filePath(QStringLiteral("plans.json")));
    trouble_.keepIn(place.filePath(QStringLiteral("crashes")));
    planning_.machine()->keepIn(place.filePath(QStringLiteral("machines")));
    recent_.keepIn(place.filePath(QStringLiteral("recent.json")));
}

void Session::showResults() {
    const Plan* const plan = shown_.plan().get();
    figures_.show(plan);
    if (shown_.isDraft()) {
        // Not looked for: what was found last stays until the whole plan says what there is.
        return;
    }
    const ProjectField* const field = document_.project()->field();
    lastChange_.show(field != nullptr ? field->id : std::string{}, shown_.plan());
    const auto& geometry = shown_.drawing().geometry();
    findings_.show(
        plan != nullptr ? plan->findings : std::vector<Finding>{},
        plan != nullptr && geometry != nullptr ? geometry->findingPlaces : std::vector<QGeoCoordinate>{});
}

void Session::offerExport() {
    const PlanState state = planning_.state();
    if (isFinished(state)) {
        farmPlans_.keep(shown_.plan());
    }
    review_.setPlan(isFinished(state) ? shown_.plan() : nullptr);
    const PlanTitle title =
        isFinished(state)
            ? PlanTitle{.plan = shown_.plan(), .name = farm_.ownName(), .finished = shown_.finished()}
            : PlanTitle{};
    exporter_.setPlan(title, state);
    printing_.setPlan(title, state);
}

}  // namespace furrow
