#pragma once

#include "planner/path/fitting_ways.h"
#include "planner/plan/path_over_legs.h"

#include <vector>

namespace furrow {

/// The legs of a plan, without the ways between them: the swaths in their order, and the headland before or
/// after them, ring by ring. Where ways in the field are quicker so, short headland passes come between other
/// legs, swaths included.
///
/// @param ways     in the room of turns
/// @param lowered  the rig for driving a pass, implement down
/// Cost: as of `headlandLegs`. With short passes also some quick searches for each, and all ways between the
/// legs, most of which the path needs, too.
/// Cancelled.
Result<std::vector<Leg>> workLegs(const DriveTask& task, WaySearches& ways, const Rig& lowered,
                                  const JobContext& job);

}  // namespace furrow
