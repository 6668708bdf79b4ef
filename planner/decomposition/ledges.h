#pragma once

#include "planner/geometry/polygon.h"

#include <vector>

namespace furrow {

/// Corners and cuts with a smaller difference of height lie on one line.
inline constexpr double kLevelM = 1e-6;

/// A level stretch of a ring, usually one corner, between the two edges that leave it.
struct Ledge {
    Point left;
    Point right;
    bool isValley = false;  ///< both edges go up from it
    bool isPeak = false;    ///< both go down
    bool isInward = false;  ///< it points into the mainland
    bool isCorner = false;  ///< the boundary turns a corner here, sharp or rounded, of no other ledge
};

/// The ledges of one ring, counter-clockwise outside and clockwise round holes. A bend drawn in edges shorter
/// than `bend` is one corner. It lies at the valley or peak of the bend, or at its level end, or else where
/// half of it is turned. Bends of less than 5 degrees do not count. Cost: O(n).
/// turned. Bends of less than 5 degrees are none. Cost: O(n).
std::vector<Ledge> ledgesOf(const Ring& ring, Length bend);

}  // namespace furrow
