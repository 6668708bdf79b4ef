#pragma once

#include "planner/plan/stages.h"

namespace furrow {

/// The cells of all parts, as the chosen decomposition has them. Cancelled.
Result<Decomposition> cellsOf(const PlanRequest& request, const LaidSwaths& laid, const JobContext& job);

}  // namespace furrow
