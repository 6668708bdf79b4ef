#pragma once

#include "planner/geometry/polygon.h"

#include <vector>

namespace furrow {

/// A level stretch of a ring, mostly one corner, between the edges that leave it.
struct Ledge {
    Point left;
    Point right;
    bool isValley = false;  ///< both edges go up from it
    bool isPeak = false;    ///< both go down
    bool isInward = false;  ///< it points into the mainland
    bool isCorner = false;  ///< the boundary turns a corner here, sharp or rounded, that lies at no other ledge
};

/// The ledges of one ring, counter-clockwise outside and clockwise round holes. Bends that are drawn in edges shorter than
/// `bend` are one corner: at its valley or peak or where it ends on something level, and otherwise where half of it is
/// turned. Bends of less than 5 degrees are none. Cost: O(n).
std::vector<Ledge> ledgesOf(const Ring& ring, Length bend);

}  // namespace furrow
