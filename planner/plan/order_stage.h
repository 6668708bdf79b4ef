#pragma once

#include "planner/plan/stages.h"

namespace furrow {

/// Divides the mainland into cells and orders the swaths, by the chosen methods. Errors: those of the route.
/// Cancelled.
Result<Ordered> orderStage(const PlanRequest& request, const LaidSwaths& laid, const JobContext& job);

/// What a route over these cells is made from. Points into all three, which must outlive it.
RouteTask routeTask(const PlanRequest& request, const SwathSet& swaths, const Decomposition& cells);

}  // namespace furrow
