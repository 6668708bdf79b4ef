#pragma once

#include "planner/plan/path_over_legs.h"

namespace furrow {

/// Where more is left than may stay, short passes over it, if the plan gets better by them. A pass that has
/// no way in is replaced by others in another round.
///
/// @param driven  over these legs
/// @param ground  where ways may lead, gates open
/// @param toBeat  InputRefused for a plan that is no better with them
/// Cancelled.
Result<Driven> finishStage(const DriveTask& task, Driven driven, std::vector<Leg> legs,
                           const PathOverLegs& path, RememberedWays& ways, const MultiPolygon& ground,
                           std::optional<PlanToBeat> toBeat, const JobContext& job);

}  // namespace furrow
