#pragma once

#include "planner/geometry/point.h"

#include <cmath>
#include <numbers>

namespace furrow {

/// The length of a displacement within a field. std::hypot also handles lengths near the ends of the number
/// range; this is ten times as fast.
inline double lengthOf(Point way) {
    return std::sqrt(dot(way, way));
}

/// An angle in radians, into [-pi, pi].
inline double wrapped(double angle) {
    return std::remainder(angle, 2.0 * std::numbers::pi);
}

}  // namespace furrow
