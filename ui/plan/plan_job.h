#pragma once

#include "planner/field/field.h"
#include "planner/jobs/job.h"
#include "planner/plan/plan.h"
#include "ui/map/plan_drawing.h"

#include <memory>
#include <optional>

namespace furrow {

/// What a planning job hands over.
struct PlanOutcome {
    std::shared_ptr<const FieldSource> source;
    std::shared_ptr<const Field> field;
    std::shared_ptr<const Plan> plan;
    PlanDrawing drawing;
    std::optional<Error> error;
};

/// Plans a field and draws the plan; without a plan, what there is of the field.
/// @param field   of this source, where it was checked before
/// @param before  of the same field, for a draft that goes on from it; null for the whole plan
/// @param cache   of the stages of plans before this one
PlanOutcome planned(const std::shared_ptr<const FieldSource>& source, std::shared_ptr<const Field> field,
                    const Machine& machine, const Settings& settings, bool draft, const Plan* before,
                    StageCache& cache, const JobContext& job);

}  // namespace furrow
