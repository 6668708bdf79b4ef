#pragma once

#include "planner/plan/path_over_legs.h"

namespace furrow {

/// Adds short passes over land that is left, if there is too much of it and the plan gets better. If no way
/// leads to a pass, not even folded, the next round tries other passes.
///
/// @param driven  the path over these legs, with its audit
/// @param legs    those of the result, afterwards
/// @param ground  the area for ways, gates open
/// @param toBeat  the best plan so far. InputRefused: this one cannot be better.
/// Cancelled.
Result<Driven> finishStage(const DriveTask& task, Driven driven, std::vector<Leg>& legs,
                           const PathOverLegs& path, RememberedWays& ways, FoldingWays* folding,
                           const AllowedAreas& ground, const std::optional<PlanToBeat>& toBeat,
                           const JobContext& job);

}  // namespace furrow
