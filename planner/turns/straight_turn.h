#pragma once

#include "planner/settings/method.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// For machines that turn on the spot: straight from place to place. The heading jumps at both ends.
Curve straightTurn(const Pose& from, const Pose& to);

extern const Method<TurnPlanner> kStraightMethod;

}  // namespace furrow
