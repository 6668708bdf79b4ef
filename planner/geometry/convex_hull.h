#pragma once

#include "planner/geometry/polygon.h"

#include <span>

namespace furrow {

/// The corners of the convex hull, counter-clockwise, without points on its edges. Fewer than three if the
/// points lie on a line. Cost: O(n log n). Source: Andrew 1979, doi 10.1016/0020-0190(79)90072-3.
Ring convexHull(std::span<const Point> points);

/// Whether a counter-clockwise ring never bends to the right, except for rounding.
bool isConvex(std::span<const Point> ring);

/// The least distance between two parallel lines that enclose a hull; always along one of its edges
/// (Houle & Toussaint 1988, doi 10.1109/34.6790). Cost: O(n) by rotating calipers.
Length minimumWidth(std::span<const Point> hull);

/// The largest distance between two corners of a hull. Cost: O(n²).
Length diameter(std::span<const Point> hull);

}  // namespace furrow
