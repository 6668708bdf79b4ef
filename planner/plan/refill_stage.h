#pragma once

#include "planner/path/gate_ways.h"
#include "planner/plan/path_over_legs.h"

#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// Adds trips to refill points, so that the tank is never empty, or the bunker full, at work. The machine
/// begins with a full tank or an empty bunker, leaves the work at the end of a swath or headland pass, and
/// goes on with the next one. Of all splits the one that adds the least time. A headland pass that takes more
/// than a whole tank is interrupted, and so is a swath if ways may cross the mainland. Any other such swath
/// is a finding, as is a refill point that the machine does not get to.
///
/// @param driven  the path over these legs
/// @param places  at least one
/// @param rig     raised, in the area for ways
/// @param toBeat  the best plan so far. InputRefused: this one cannot be better.
/// Cost: some dozen searched ways and one to three paths with their audits. Cancelled.
Result<Driven> refillStage(const DriveTask& task, Driven driven, const std::vector<Leg>& legs,
                           std::span<const RoutePlace> places, const PathOverLegs& path, const Rig& rig,
                           std::optional<PlanToBeat> toBeat, const JobContext& job);

}  // namespace furrow
