#pragma once

#include "planner/turns/turn_method.h"

namespace furrow {

/// Where the vehicle's reference point is while the middle of the implement is at `implement`.
Pose vehicleAt(const Pose& implement, const Machine& machine);

/// The way from where one working stretch ends to where the next begins, both poses of the vehicle: the turn
/// itself and the straight run-in that the implement needs before it is lowered. Straight ahead on the same
/// line there is nothing to straighten out from, and what turns on the spot is straight at once: no run-in.
Turn connection(const Pose& leaving, const Pose& arriving, const Machine& machine, TurnPlanner* turn);

}  // namespace furrow
