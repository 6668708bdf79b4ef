#pragma once

#include "planner/machine/machine.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// How far the machine's footprint reaches beyond the edge of the mainland when it turns from one swath
/// into the next: the most over edges that meet the swaths at 45 to 135 degrees. Cost: a dozen turns.
/// @param drawnOut  swaths are drawn out until their full width is covered
Length roomForTurns(const Machine& machine, TurnPlanner* turn, bool drawnOut);

/// The same for edges that meet the swaths at this angle, in (0, pi); flat ones count as 15 degrees.
Length roomForTurnsAt(Angle angle, const Machine& machine, TurnPlanner* turn, bool drawnOut);

/// How far ahead of where the implement leaves a swath the footprint gets on the way to the next, level, one.
Length reachOfLevelTurn(const Machine& machine, TurnPlanner* turn);

}  // namespace furrow
