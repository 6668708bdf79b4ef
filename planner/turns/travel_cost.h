#pragma once

#include "planner/geometry/curve.h"

#include <functional>

namespace furrow {

/// The cost of a metre at a place, relative to elsewhere; at least 1. Empty: every place costs the same.
using TravelCost = std::function<double(Point)>;

/// The mean along a piece of a turn, sampled once for each `step`. 1 if `travel` is empty.
double meanCost(const TravelCost& travel, const Pose& from, const CurvePiece& piece, Length step);

/// If a way costs this many times its time, another way is searched.
inline constexpr double kDearWay = 1.5;

}  // namespace furrow
