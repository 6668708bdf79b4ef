#include "planner/field/small_obstacles.h"

#include "planner/geometry/convex_hull.h"

#include <algorithm>

namespace furrow {

namespace {

/// Whether a part of the field lies inside a hole, as on an island.
bool holdsPart(const MultiPolygon& polygons, const Ring& ring) {
    const Bounds box = bounds(ring);
    return std::ranges::any_of(polygons, [&](const Polygon& polygon) {
        const Bounds part = bounds(polygon);
        return part.min.x > box.min.x && part.max.x < box.max.x && part.min.y > box.min.y &&
               part.max.y < box.max.y;
    });
}

}  // namespace

std::vector<Ring> smallObstacles(const Field& field, Length upTo) {
    std::vector<Ring> small;
    for (const Polygon& polygon : field.drivable()) {
        for (const Ring& hole : polygon.holes) {
            if (diameter(convexHull(hole)) <= upTo && !holdsPart(field.drivable(), hole)) {
                small.push_back(hole);
            }
        }
    }
    return small;
}

MultiPolygon filled(MultiPolygon polygons, std::span<const Ring> holes) {
    for (Polygon& polygon : polygons) {
        std::erase_if(polygon.holes,
                      [holes](const Ring& hole) { return std::ranges::contains(holes, hole); });
    }
    return polygons;
}

}  // namespace furrow
