#pragma once

#include "planner/field/field.h"
#include "planner/jobs/job.h"
#include "planner/plan/plan_course.h"
#include "ui/map/plan_drawing.h"

#include <chrono>
#include <functional>
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

/// What is to be planned.
struct PlanTask {
    std::shared_ptr<const FieldSource> source;
    std::shared_ptr<const Field> field = {};  ///< of this source, where it was checked before
    Machine machine;
    Settings settings;
    bool draft = false;                       ///< a draft only
    std::shared_ptr<const Plan> before = {};  ///< of the same field, for a draft to go on from
};

/// What is handed over before the plan is there, from threads of the job.
struct PlanMeanwhile {
    /// A draft, made beside the plan, then the first plan (isFirstPlan) where that is there much earlier
    /// than the finished one. Neither comes behind the plan, nor a draft behind a first plan.
    std::function<void(PlanOutcome)> firstPlan;
    /// No draft is begun before. For plans that are mostly there by then.
    std::chrono::milliseconds draftAfter{0};
    /// No first plan that is there before is handed over: behind it the finished one comes so soon that
    /// drawing both is not worth it.
    std::chrono::milliseconds firstPlanAfter{300};
    PlanCourse course = {};
};

/// Plans a field and draws the plan; without a plan, what there is of the field.
/// @param cache  of the stages of plans before this one
PlanOutcome planned(const PlanTask& task, StageCache& cache, const JobContext& job,
                    const PlanMeanwhile& meanwhile = {});

}  // namespace furrow
