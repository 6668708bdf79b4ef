#pragma once

#include "planner/machine/machine.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// How far the machine's footprint reaches beyond the edge of the mainland when it turns from one swath
/// into the next: the most over edges that meet the swaths at 45 to 135 degrees. Cost: a dozen turns.
Length roomForTurns(const Machine& machine, TurnPlanner* turn);

}  // namespace furrow
