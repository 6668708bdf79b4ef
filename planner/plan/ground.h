#pragma once

#include "planner/plan/stages.h"

namespace furrow {

/// Where the machine may be. InputRefused: it fits nowhere in the field. Cancelled.
Result<Ground> groundOf(const PlanRequest& request, const JobContext& job);

}  // namespace furrow
