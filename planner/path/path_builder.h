#pragma once

#include "planner/machine/machine.h"
#include "planner/path/path.h"
#include "planner/route/route.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// The line that the machine drives: every swath of the route, joined by turns in free space.
///
/// @return segments in driving order, each sampled at every change of curvature and so that chords stay
///         within 5 mm of the curve; position is continuous, heading too unless the turns are `straight`.
/// Speed is constant on swaths and on turns. Cost: O(samples). Cancelled.
Result<Path> buildPath(const SwathSet& swaths, const Route& route, const Machine& machine, TurnPlanner* turn,
                       const JobContext& job);

}  // namespace furrow
