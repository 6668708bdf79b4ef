#pragma once

#include "planner/machine/machine.h"
#include "planner/path/path.h"
#include "planner/route/route.h"
#include "planner/turns/turn_method.h"

#include <functional>
#include <span>
#include <vector>

namespace furrow {

/// A planned stretch of the path: vehicle poses, before speed and time.
struct Leg {
    SegmentKind kind = SegmentKind::Swath;
    int number = 0;  ///< of the swath or headland pass
    Curve line;      ///< of the vehicle's reference point
    bool implementDown = true;
    bool folded = false;   ///< driven with the implement folded for the road
    bool refills = false;  ///< at its end the machine stands at a refill point
};

/// One leg for each step of the route.
std::vector<Leg> swathLegs(const SwathSet& swaths, const Route& route, const Machine& machine);

/// What leads from one leg to the next.
struct WayBetween {
    Curve line;
    bool folded = false;  ///< it fits only with the implement folded for the road
};

/// Finds the way from the end of one leg to the start of the next. Called by several threads at once.
using WayFinder = std::function<WayBetween(const Leg& leaving, const Leg& arriving, const JobContext& job)>;

/// Turns of one kind in free space.
WayFinder waysBy(TurnPlanner* turn, const Machine& machine);

/// These legs in their order, joined by ways where a leg does not begin at the end of the one before. A way
/// that turns on the spot in between is several legs.
/// Cancelled.
Result<std::vector<Leg>> joinedLegs(std::span<const Leg> legs, const Machine& machine, const WayFinder& way,
                                    const JobContext& job);

}  // namespace furrow
