#include "planner/field/small_obstacles.h"

#include "planner/geometry/convex_hull.h"

#include <algorithm>

namespace furrow {

namespace {

// Holes of the workable and of the drivable area that are the same are so to this.
constexpr double kSameM = 1e-3;

Bounds boxOf(const Ring& ring) {
    return bounds({{.outer = ring, .holes = {}}});
}

bool isSame(const Bounds& a, const Bounds& b) {
    return distance(a.min, b.min) < kSameM && distance(a.max, b.max) < kSameM;
}

bool isHoleOf(const MultiPolygon& polygons, const Ring& ring) {
    const Bounds box = boxOf(ring);
    return std::ranges::any_of(polygons, [&](const Polygon& polygon) {
        return std::ranges::any_of(polygon.holes, [&](const Ring& hole) { return isSame(boxOf(hole), box); });
    });
}

/// A part of the field inside of a hole, as on an island.
bool holdsPart(const MultiPolygon& polygons, const Ring& ring) {
    const Bounds box = boxOf(ring);
    return std::ranges::any_of(polygons, [&](const Polygon& polygon) {
        const Bounds part = bounds({polygon});
        return part.min.x > box.min.x && part.max.x < box.max.x && part.min.y > box.min.y && part.max.y < box.max.y;
    });
}

}  // namespace

std::vector<Ring> smallObstacles(const Field& field, Length upTo) {
    std::vector<Ring> small;
    for (const Polygon& polygon : field.workable()) {
        for (const Ring& hole : polygon.holes) {
            if (diameter(convexHull(hole)) <= upTo && isHoleOf(field.drivable(), hole) &&
                !holdsPart(field.workable(), hole)) {
                small.push_back(hole);
            }
        }
    }
    return small;
}

MultiPolygon filled(MultiPolygon polygons, std::span<const Ring> holes) {
    for (Polygon& polygon : polygons) {
        std::erase_if(polygon.holes, [holes](const Ring& hole) { return std::ranges::contains(holes, hole); });
    }
    return polygons;
}

}  // namespace furrow
