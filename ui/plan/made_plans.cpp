#include "ui/plan/made_plans.h"

#include "planner/plan/advice.h"
#include "planner/project/field_tasks.h"
#include "planner/project/plan_key.h"

#include <algorithm>

namespace furrow {

namespace {

std::size_t samplesOf(const Plan& plan) {
    std::size_t samples = 0;
    for (const PathSegment& segment : plan.path.segments) {
        samples += segment.samples.size();
    }
    return samples;
}

}  // namespace

void MadePlans::keep(const std::string& planKey, const MadePlan& made) {
    if (!made || made.plan->request.draft) {
        return;
    }
    if (const auto known = plans_.find(planKey); known != plans_.end()) {
        if (known->second.made.advised && !made.advised) {
            return;
        }
        samples_ -= known->second.samples;
        plans_.erase(known);
    }
    const std::size_t samples = samplesOf(*made.plan);
    samples_ += samples;
    plans_.insert_or_assign(planKey, Kept{.made = made, .samples = samples, .age = next_++});
    while (samples_ > mostSamples_) {
        const auto oldest =
            std::ranges::min_element(plans_, {}, [](const auto& entry) { return entry.second.age; });
        samples_ -= oldest->second.samples;
        plans_.erase(oldest);
    }
}

MadePlan MadePlans::find(const ProjectField& field, const FieldPlan& wanted) const {
    const auto found = plans_.find(planKey(*field.source, wanted));
    // A key is short: what it leads to is looked at.
    return found != plans_.end() && found->second.made.plan->field().source() == *field.source &&
                   found->second.made.plan->request.machine == wanted.machine &&
                   found->second.made.plan->request.settings == wanted.settings
               ? found->second.made
               : MadePlan{};
}

Result<std::shared_ptr<const Plan>> advisedPlan(const MadePlan& there, const FieldSource& source,
                                                const Machine& machine, const Settings& settings,
                                                const JobContext& job) {
    if (!there) {
        return advisedPlanOfSource(source, machine, settings, job);
    }
    return there.advised ? Result<std::shared_ptr<const Plan>>{there.plan} : withAdvice(there.plan, job);
}

}  // namespace furrow
