#pragma once

#include "planner/settings/method.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// The shortest forward-only curve between two poses whose radius is never below the given one. It is the
/// best of the six words LSL, RSR, LSR, RSL, RLR, LRL in closed form. The end pose is exact except for
/// rounding. Source: Dubins 1957, doi 10.2307/2372560; solved for the centres of the arcs, the words as in
/// Shkel & Lumelsky 2001, doi 10.1016/S0921-8890(00)00127-5.
Curve dubinsTurn(const Pose& from, const Pose& to, Length radius);

/// The length of that curve only, several times cheaper than the curve.
Length dubinsLength(const Pose& from, const Pose& to, Length radius);

extern const Method<TurnPlanner> kDubinsMethod;

}  // namespace furrow
