#pragma once

#include "planner/geometry/point.h"

#include <cmath>

namespace furrow {

/// Of a displacement within a field: without the care that std::hypot takes of lengths near the ends of the
/// number range, and ten times as fast.
inline double lengthOf(Point way) {
    return std::sqrt(dot(way, way));
}

}  // namespace furrow
