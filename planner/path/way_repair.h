#pragma once

#include "planner/path/driven_parts.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"
#include "planner/turns/rig.h"

#include <vector>

namespace furrow {

/// The legs in an order and a direction in which ways lead from each to the next. If a way is missing, a
/// headland pass beside that place is changed. A closed pass begins somewhere else. Others are driven in the
/// other direction, or between two other legs. The first change is taken that leaves no other place without a
/// way. A place without such a change stays, as do swaths, and places between parts without a way from one to
/// the other.
///
/// @param lowered  the rig for driving a pass, implement down
/// Cost: only lookups if all ways were found before; some dozen quick searches for each missing way.
std::vector<Leg> withWaysBetween(std::vector<Leg> legs, RememberedWays& ways, const Rig& lowered,
                                 const DrivenParts& parts, const JobContext& job);

/// The legs sorted by part, the part of the first leg first and that of the last leg last. Within each part
/// the order stays.
std::vector<Leg> partByPart(std::vector<Leg> legs, const DrivenParts& parts);

}  // namespace furrow
