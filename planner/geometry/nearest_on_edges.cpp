#include "planner/geometry/nearest_on_edges.h"

#include "planner/geometry/segment.h"

#include <limits>

namespace furrow {

std::optional<Point> nearestOnEdges(const MultiPolygon& polygons, Point point) {
    std::optional<Point> nearest;
    double least = std::numeric_limits<double>::infinity();
    forEachEdge(polygons, [&](Point from, Point to) {
        const Point at = nearestOnSegment(point, from, to);
        if (const double away = distance(point, at); away < least) {
            least = away;
            nearest = at;
        }
    });
    return nearest;
}

}  // namespace furrow
