#pragma once

#include "planner/geometry/polygon.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace furrow {

/// The turn of a ring at one of its points, positive to the left, and the direction inwards.
struct Bend {
    double turnRad = 0.0;
    Point inward;
};

inline Bend bendAt(const Ring& ring, std::size_t i) {
    const Point in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Point out = ring[(i + 1) % ring.size()] - ring[i];
    const double turn = std::atan2(cross(in, out), dot(in, out));
    return {turn, direction(std::atan2(in.y, in.x) + 0.5 * turn + 0.5 * std::numbers::pi)};
}

}  // namespace furrow
