#include "ui/plan/plan_job.h"

#include "planner/jobs/wide_registers.h"
#include "planner/plan/advice.h"
#include "planner/plan/draft.h"
#include "planner/project/field_tasks.h"
#include "ui/jobs/job_runner.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace furrow {

namespace {

using std::chrono::steady_clock;

PlanOutcome outcomeOf(const PlanTask& task, const std::shared_ptr<const Field>& field,
                      const Result<std::shared_ptr<const Plan>>& plan) {
    if (!plan) {
        return {.source = task.source,
                .field = field,
                .plan = {},
                .drawing = PlanDrawing{fieldGeometry(*field, plan.error().place)},
                .error = plan.error()};
    }
    return {.source = task.source,
            .field = field,
            .plan = *plan,
            .drawing = PlanDrawing{planGeometry(**plan)},
            .error = {}};
}

/// Lets through what is better than what came before, in this order.
class HandOvers {
public:
    enum class Rank { Draft, FirstPlan, Plan };

    explicit HandOvers(const PlanMeanwhile& meanwhile) : meanwhile_{meanwhile} {}

    void pass(Rank rank, PlanOutcome outcome) {
        const std::scoped_lock lock{mutex_};
        if (rank >= next_) {
            next_ = rank;
            meanwhile_.firstPlan(std::move(outcome));
        }
    }
    /// The plan is there.
    void close() {
        const std::scoped_lock lock{mutex_};
        next_ = Rank::Plan;
    }

private:
    const PlanMeanwhile& meanwhile_;
    std::mutex mutex_;
    Rank next_ = Rank::Draft;
};

/// A draft on a thread of its own, beside the plan. It ends with this object.
class DraftBeside {
public:
    DraftBeside(const PlanTask& task, const PlanRequest& request, HandOvers& handOvers,
                std::chrono::milliseconds after, StageCache& cache, const JobContext& job)
        : thread_{[this, &task, request = draftOf(request, task.before.get()), &handOvers, after,
                   &cache](const std::stop_token& stop) {
              giveWayToTheWindow();
              clearWideRegisters();
              if (isStopped(stop, after)) {
                  return;
              }
              // Without a draft the plan tells the reason.
              if (const auto draft =
                      makePlan(request, {.stop = stop, .progress = {}, .threads = 1}, &cache)) {
                  handOvers.pass(HandOvers::Rank::Draft, outcomeOf(task, request.field, draft));
              }
          }},
          onStop_{job.stop, [source = thread_.get_stop_source()]() mutable { source.request_stop(); }} {}

private:
    bool isStopped(const std::stop_token& stop, std::chrono::milliseconds within) {
        std::unique_lock lock{mutex_};
        wake_.wait_for(lock, stop, within, [] { return false; });
        return stop.stop_requested();
    }

    std::mutex mutex_;
    std::condition_variable_any wake_;
    std::jthread thread_;
    std::stop_callback<std::function<void()>> onStop_;
};

}  // namespace

PlanOutcome planned(const PlanTask& task, StageCache& cache, const JobContext& job,
                    const PlanMeanwhile& meanwhile) {
    const steady_clock::time_point begun = steady_clock::now();
    std::shared_ptr<const Field> field = task.field;
    if (!field) {
        auto made = Field::create(*task.source, job.part(0.0, 0.05));
        if (!made) {
            return {.source = task.source,
                    .field = {},
                    .plan = {},
                    .drawing = PlanDrawing{outlineGeometry(*task.source, made.error().place)},
                    .error = made.error()};
        }
        field = std::make_shared<const Field>(std::move(*made));
    }
    const auto request = planRequest(field, task.machine, task.settings, job.withoutProgress());
    if (!request) {
        return outcomeOf(task, field, std::unexpected(request.error()));
    }
    if (task.draft) {
        return outcomeOf(task, field,
                         makePlan(draftOf(*request, task.before.get()), job.part(0.05, 0.95), &cache));
    }
    HandOvers handOvers{meanwhile};
    PlanCourse course = meanwhile.course;
    std::optional<DraftBeside> draft;
    if (meanwhile.firstPlan) {
        course.firstPlan = [&](const std::shared_ptr<const Plan>& plan) {
            if (steady_clock::now() - begun >= meanwhile.firstPlanAfter) {
                handOvers.pass(HandOvers::Rank::FirstPlan, outcomeOf(task, field, plan));
            }
        };
        draft.emplace(task, *request, handOvers, meanwhile.draftAfter, cache, job);
    }
    const auto plan = makePlan(*request, job.part(0.05, 0.8), &cache, course).and_then([&](const auto& made) {
        return withAdvice(made, job.part(0.8, 0.95), &cache);
    });
    handOvers.close();
    draft.reset();
    PlanOutcome outcome = outcomeOf(task, field, plan);
    job.report(1.0);
    return outcome;
}

}  // namespace furrow
