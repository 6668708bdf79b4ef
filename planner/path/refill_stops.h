#pragma once

#include "planner/field/field.h"
#include "planner/path/gate_ways.h"
#include "planner/path/path_builder.h"
#include "planner/turns/rig.h"

#include <vector>

namespace furrow {

/// The farthest that a machine stops from a refill point: beside an edge, no nearer place has room for it.
Length refillReach(const Machine& machine);

/// Short straights on which the machine draws up at a refill point, along the edge of the field in both
/// directions if that fits, and otherwise in any direction. They end as near to the point as the machine
/// fits. Empty if it fits nowhere within `refillReach`. Cost: some thousand tests of the footprint at most.
std::vector<Leg> refillStops(const RoutePlace& place, const Field& field, const Rig& rig);

}  // namespace furrow
