#include "ui/map/shown_plan.h"

#include <utility>

namespace furrow {

void ShownPlan::begin(Source source) {
    source_ = std::move(source);
    plan_.reset();
    drawing_ = source_ ? PlanDrawing{outlineGeometry(*source_, std::nullopt)} : PlanDrawing{};
    drawnSource_ = source_;
    emit planChanged();
    emit drawingChanged();
    emit behindChanged();
}

void ShownPlan::follow(Source source) {
    source_ = std::move(source);
    emit behindChanged();
}

void ShownPlan::show(std::shared_ptr<const Plan> plan, PlanDrawing drawing, Source drawn) {
    plan_ = std::move(plan);
    finished_ = QDateTime::currentDateTime();
    drawing_ = std::move(drawing);
    drawnSource_ = std::move(drawn);
    emit behindChanged();
    emit drawingChanged();
    emit planChanged();
}

}  // namespace furrow
