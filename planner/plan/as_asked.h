#pragma once

#include "planner/plan/plan.h"

namespace furrow {

/// All stages once, with just these settings: whatever makePlan compares and advice tries. Errors: as makePlan.
Result<std::shared_ptr<Plan>> planAsAsked(const PlanRequest& request, const JobContext& job);

}  // namespace furrow
