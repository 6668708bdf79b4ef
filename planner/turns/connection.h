#pragma once

#include "planner/turns/turn_method.h"

namespace furrow {

/// The pose of the vehicle's reference point when the middle of the implement is at `implement`.
Pose vehicleAt(const Pose& implement, const Machine& machine);

/// The way from the end of one working stretch to the start of the next, both poses of the vehicle. It is the
/// turn and the straight run-in that the implement needs before it is lowered. Two cases need no run-in:
/// straight ahead on the same line, and turns on the spot.
Curve connection(const Pose& leaving, const Pose& arriving, const Machine& machine, TurnPlanner* turn);

}  // namespace furrow
