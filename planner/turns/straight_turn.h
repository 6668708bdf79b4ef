#pragma once

#include "planner/settings/method.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// For machines that turn on the spot: straight from place to place. The heading jumps at both ends.
Curve straightTurn(const Pose& from, const Pose& to);

/// A trailed implement does not turn with its tractor.
bool canTurnOnTheSpot(const Machine& machine);

/// The time for a way from standing to standing.
Duration fromStandToStand(Length way, const Machine& machine);

/// The time to turn by an angle, standing: the outer wheel drives round the middle at the turning speed, and
/// speeds up and brakes as on any way.
Duration turningOnTheSpot(Angle turn, const Machine& machine);
/// The same from one heading to another; none where they differ by no more than rounding.
Duration turningOnTheSpot(const Pose& from, const Pose& to, const Machine& machine);
/// The same for what a way turns at its two ends.
Duration turningOnTheSpot(const Curve& way, const Pose& from, const Pose& to, const Machine& machine);
/// The time of a way between two poses, with what it turns on the spot. If it is straight from turn to turn,
/// speeding up and braking count.
Duration roughDuration(const Curve& way, const Pose& from, const Pose& to, const Machine& machine);
/// The same, with a transfer at its speed.
Duration drivenDuration(const Curve& way, const Pose& from, const Pose& to, const Machine& machine);

extern const Method<TurnPlanner> kStraightMethod;

}  // namespace furrow
