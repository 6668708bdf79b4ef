#pragma once

#include "planner/geometry/polygon.h"

namespace furrow {

/// A rectangle beside a line.
struct Strip {
    Point from;
    Point along;  ///< unit vector
    double lengthM = 0.0;
    double halfWidthM = 0.0;  ///< to either side of the line
};

/// The area of a polygon inside a strip, as the clipped polygon would have it, without making that: the
/// integral along the strip under each edge, cut off at the strip's sides (Green's theorem). Cost: O(n),
/// nothing allocated.
double areaInM2(const Polygon& polygon, const Strip& strip);

}  // namespace furrow
