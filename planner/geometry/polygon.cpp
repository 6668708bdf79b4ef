#include "planner/geometry/polygon.h"

#include "planner/geometry/segment.h"

#include <algorithm>
#include <utility>

namespace furrow {

double signedAreaM2(std::span<const Point> ring) {
    if (ring.size() < 3) {
        return 0.0;
    }
    // Relative to the first point, to avoid cancellation for rings far from the origin.
    const Point origin = ring.front();
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        twice += cross(ring[i] - origin, ring[i + 1] - origin);
    }
    return 0.5 * twice;
}

Area area(const Polygon& polygon) {
    double sum = std::abs(signedAreaM2(polygon.outer));
    for (const Ring& hole : polygon.holes) {
        sum -= std::abs(signedAreaM2(hole));
    }
    return squareMetres(sum);
}

Area area(const MultiPolygon& polygons) {
    Area sum;
    for (const Polygon& polygon : polygons) {
        sum += area(polygon);
    }
    return sum;
}

MultiPolygon withoutHoles(const MultiPolygon& polygons) {
    MultiPolygon filled;
    filled.reserve(polygons.size());
    for (const Polygon& polygon : polygons) {
        filled.push_back({.outer = polygon.outer, .holes = {}});
    }
    return filled;
}

Bounds bounds(const Polygon& polygon) {
    return bounds(polygon.outer);
}

Bounds bounds(const MultiPolygon& polygons) {
    if (polygons.empty()) {
        return {};
    }
    Bounds box = bounds(polygons.front());
    for (const Polygon& polygon : polygons) {
        box = joined(box, bounds(polygon));
    }
    return box;
}

double lengthM(std::span<const Point> line) {
    double sum = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        sum += distance(line[i - 1], line[i]);
    }
    return sum;
}

bool isInside(std::span<const Point> ring, Point point) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        inside ^= meetsRay(point, ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
    }
    return inside;
}

bool isInside(const Polygon& polygon, Point point) {
    bool inside = isInside(polygon.outer, point);
    for (const Ring& hole : polygon.holes) {
        inside ^= isInside(hole, point);
    }
    return inside;
}

bool isInside(const MultiPolygon& polygons, Point point) {
    return std::ranges::any_of(polygons,
                               [point](const Polygon& polygon) { return isInside(polygon, point); });
}

std::vector<Point> placesInside(const Polygon& polygon, double stepM) {
    const MultiPolygon alone{polygon};
    const Bounds box = bounds(alone);
    std::vector<Point> places;
    std::vector<std::pair<Point, Point>> crossing;
    for (double y = box.min.y + 0.5 * stepM; y < box.max.y; y += stepM) {
        crossing.clear();
        forEachEdge(alone, [&](Point from, Point to) {
            if ((from.y > y) != (to.y > y)) {
                crossing.emplace_back(from, to);
            }
        });
        for (double x = box.min.x + 0.5 * stepM; x < box.max.x; x += stepM) {
            bool inside = false;
            for (const auto& [from, to] : crossing) {
                inside ^= meetsRay({x, y}, from, to);
            }
            if (inside) {
                places.push_back({x, y});
            }
        }
    }
    return places;
}

std::size_t vertexCount(const MultiPolygon& polygons) {
    std::size_t count = 0;
    for (const Polygon& polygon : polygons) {
        count += polygon.outer.size();
        for (const Ring& hole : polygon.holes) {
            count += hole.size();
        }
    }
    return count;
}

}  // namespace furrow
