#pragma once

#include "planner/machine/machine.h"
#include "planner/path/path.h"
#include "planner/route/route.h"
#include "planner/turns/turn_method.h"

#include <functional>
#include <span>
#include <vector>

namespace furrow {

/// A stretch of the path as it is laid out: vehicle poses, before speed and time.
struct Leg {
    SegmentKind kind = SegmentKind::Swath;
    int number = 0;  ///< of the swath or headland pass
    Turn line;       ///< of the vehicle's reference point
    bool implementDown = true;
};

/// One leg for each step of the route.
std::vector<Leg> swathLegs(const SwathSet& swaths, const Route& route, const Machine& machine);

/// Finds the way from the end of one leg to where the next begins; asked by several threads at once.
using WayFinder = std::function<Turn(const Leg& leaving, const Leg& arriving, const JobContext& job)>;

/// Turns of one kind in free space.
WayFinder waysBy(TurnPlanner* turn, const Machine& machine);

/// The line that the machine drives: these legs in their order, joined by ways where one does not begin where the
/// one before ends.
///
/// @return segments in driving order, each sampled at every change of curvature and so that chords stay
///         within 5 mm of the curve; position is continuous, heading too unless the turns are `straight`.
/// Speed starts and ends at 0, stops where gear or heading change, and obeys the limits for work, turns,
/// reversing, sideways and lengthwise acceleration; a turn lasts at least as long as the implement needs to be
/// lifted and lowered. Between two samples the acceleration is constant. Cost: O(samples). Cancelled.
Result<Path> buildPath(std::span<const Leg> legs, const Machine& machine, const WayFinder& way, const JobContext& job);

}  // namespace furrow
