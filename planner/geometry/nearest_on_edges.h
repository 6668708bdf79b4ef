#pragma once

#include "planner/geometry/polygon.h"

#include <optional>

namespace furrow {

/// The place on the edges of polygons and holes that is nearest to a point; of several the first. Empty
/// without edges. O(n).
std::optional<Point> nearestOnEdges(const MultiPolygon& polygons, Point point);

}  // namespace furrow
