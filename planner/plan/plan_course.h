#pragma once

#include "planner/plan/plan.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace furrow {

/// What is told of a plan while it is made, beside the share of the work. From whichever thread got there;
/// each may be empty.
struct PlanCourse {
    /// The plan as asked, before it is compared with others: whole and measured, but only to be looked at, as
    /// its request says (draft).
    std::function<void(const std::shared_ptr<const Plan>&)> firstPlan;
    /// So many of the plans are compared that are known by now to be worth it; more may turn up.
    std::function<void(std::size_t done, std::size_t known)> compared;
};

/// The same plan as makePlan without a course. Of a draft nothing is told.
Result<std::shared_ptr<const Plan>> makePlan(const PlanRequest& request, const JobContext& job,
                                             StageCache* cache, const PlanCourse& course);

/// Whether a plan that is only to be looked at was measured: a first plan, not a draft.
inline bool isFirstPlan(const Plan& plan) {
    return plan.request.draft && plan.audit.coveredShare.has_value();
}

}  // namespace furrow
