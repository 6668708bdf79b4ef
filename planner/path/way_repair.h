#pragma once

#include "planner/path/driven_parts.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"
#include "planner/turns/rig.h"

#include <vector>

namespace furrow {

/// The legs in an order and a direction in which ways lead from each to the next. Where none was found a headland pass
/// beside that place begins somewhere else if it is closed, is driven the other way round, or is driven between two
/// other legs: whatever is found first and leaves no other place without a way. What cannot be mended so stays as it
/// is, as do swaths and what lies between parts without a way from one to the other.
///
/// @param lowered  what drives a pass, implement down
/// Cost: nothing but looking up where all ways were found before; some dozen quick searches for each that was not.
std::vector<Leg> withWaysBetween(std::vector<Leg> legs, RememberedWays& ways, const Rig& lowered, const DrivenParts& parts,
                                 const JobContext& job);

/// The legs of one part after those of another, the part of the first leg first and that of the last one last; within
/// each as they were.
std::vector<Leg> partByPart(std::vector<Leg> legs, const DrivenParts& parts);

}  // namespace furrow
