#include "ui/plan/plan_job.h"

#include "planner/plan/advice.h"
#include "planner/plan/draft.h"
#include "planner/project/field_tasks.h"

namespace furrow {

PlanOutcome planned(const std::shared_ptr<const FieldSource>& source, std::shared_ptr<const Field> field,
                    const Machine& machine, const Settings& settings, bool draft, const Plan* before,
                    StageCache& cache, const JobContext& job) {
    if (!field) {
        auto made = Field::create(*source, job.part(0.0, 0.1));
        if (!made) {
            return {.source = source,
                    .field = {},
                    .plan = {},
                    .drawing = PlanDrawing{outlineGeometry(*source, made.error().place)},
                    .error = made.error()};
        }
        field = std::make_shared<const Field>(std::move(*made));
    }
    const auto plan = planRequest(field, machine, settings, job).and_then([&](PlanRequest request) {
        return makePlan(draft ? draftOf(std::move(request), before) : request, job.part(0.1, 0.9), &cache)
            .and_then([&](const std::shared_ptr<const Plan>& made) {
                return withAdvice(made, job.part(0.9, 0.95), &cache);
            });
    });
    if (!plan) {
        return {.source = source,
                .field = field,
                .plan = {},
                .drawing = PlanDrawing{fieldGeometry(*field, plan.error().place)},
                .error = plan.error()};
    }
    PlanDrawing drawing{planGeometry(**plan)};
    job.report(1.0);
    return {.source = source,
            .field = std::move(field),
            .plan = *plan,
            .drawing = std::move(drawing),
            .error = {}};
}

}  // namespace furrow
