#pragma once

#include "planner/turns/best_feasible.h"
#include "planner/turns/continuous_curvature.h"
#include "planner/turns/dubins.h"
#include "planner/turns/named_turns.h"
#include "planner/turns/reeds_shepp.h"
#include "planner/turns/straight_turn.h"

#include <array>

namespace furrow {

/// Every method of the stage, the default first.
inline constexpr std::array kTurnMethods{
    &kBestFeasibleMethod,
    // the shortest curves
    &kDubinsMethod,
    &kReedsSheppMethod,
    &kContinuousDubinsMethod,
    &kContinuousReedsSheppMethod,
    // the turns of farm practice
    &kUTurnMethod,
    &kOmegaMethod,
    &kPTurnMethod,
    &kFishtailMethod,
    &kThreePointMethod,
    // no curve at all
    &kStraightMethod,
};

}  // namespace furrow
