#pragma once

#include "planner/plan/plan.h"

#include <optional>

namespace furrow {

/// All stages once, with just these settings: whatever makePlan compares and advice tries.
///
/// @param atMost  a path that takes longer is of no use: InputRefused, without the audit
/// Errors: as makePlan.
Result<std::shared_ptr<Plan>> planAsAsked(const PlanRequest& request, const JobContext& job, std::optional<Duration> atMost = {});

/// What the route of a plan is made from. Points into the plan, which must outlive it.
RouteTask routeTask(const Plan& plan);

}  // namespace furrow
