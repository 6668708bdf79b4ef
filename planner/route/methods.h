#pragma once

#include "planner/route/route.h"
#include "planner/settings/method.h"

#include <array>

namespace furrow {

/// The corner of a pattern at which the route starts.
extern const Parameter kCorner;
extern const Parameter kCluster;
extern const Parameter kSkip;
extern const Parameter kOrder;
extern const Parameter kLocked;
/// The swaths at the beginning and the end, by number.
extern const Parameter kFirstSwath;
extern const Parameter kLastSwath;
/// The most strips that may be open at a time.
extern const Parameter kOpenStrips;

extern const Method<RoutePlanner> kOptimisedMethod;
extern const Method<RoutePlanner> kBoustrophedonMethod;
extern const Method<RoutePlanner> kSnakeMethod;
extern const Method<RoutePlanner> kSpiralMethod;
extern const Method<RoutePlanner> kSkipMethod;
extern const Method<RoutePlanner> kRacetrackMethod;
extern const Method<RoutePlanner> kCustomMethod;

/// Every method of the stage, the default first.
inline constexpr std::array kRouteMethods{
    &kOptimisedMethod, &kBoustrophedonMethod, &kSnakeMethod,  &kSpiralMethod,
    &kSkipMethod,      &kRacetrackMethod,     &kCustomMethod,
};

/// Whether the searched order is bound to swaths by their numbers.
bool namesSwaths(const Settings& settings);

}  // namespace furrow
