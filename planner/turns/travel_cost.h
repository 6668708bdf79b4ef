#pragma once

#include "planner/turns/turn.h"

#include <functional>

namespace furrow {

/// How much dearer than elsewhere a metre is at a place; at least 1. Empty: every place costs the same.
using TravelCost = std::function<double(Point)>;

/// The mean along a piece of a turn, looked at a place for each `step`; 1 where `travel` is empty.
double meanCost(const TravelCost& travel, const Pose& from, const TurnPiece& piece, Length step);

/// A way that is dearer by this than its time alone is worth looking for another.
inline constexpr double kDearWay = 1.5;

}  // namespace furrow
