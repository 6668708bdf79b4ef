#pragma once

#include "planner/machine/machine.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// The distance that the footprint reaches beyond the edge of the mainland on a turn from one swath into the
/// next. The largest over edges that meet the swaths at 45 to 135 degrees. Cost: a dozen turns.
/// @param drawnOut  swaths are extended until their full width is covered
/// @param overhang  how far the implement may stand over every edge
Length roomForTurns(const Machine& machine, TurnPlanner* turn, bool drawnOut, Length overhang = {});

/// The same for edges that meet the swaths at this angle, in (0, pi). Angles below 15 degrees count as 15.
Length roomForTurnsAt(Angle angle, const Machine& machine, TurnPlanner* turn, bool drawnOut,
                      Length overhang = {});

/// The distance that the footprint reaches ahead of the implement's exit from a swath, on the turn to the
/// next, level swath.
Length reachOfLevelTurn(const Machine& machine, TurnPlanner* turn);

}  // namespace furrow
