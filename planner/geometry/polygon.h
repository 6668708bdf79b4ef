#pragma once

#include "planner/geometry/bounds.h"
#include "planner/geometry/point.h"
#include "planner/units/quantity.h"

#include <cstddef>
#include <span>
#include <vector>

namespace furrow {

/// A closed ring of at least three points in metres; the first point is not repeated at the end.
using Ring = std::vector<Point>;

/// A line of at least two points in metres.
using Polyline = std::vector<Point>;

/// Outer ring counter-clockwise, holes clockwise, without crossings. The maker of a Polygon has to ensure
/// that.
struct Polygon {
    Ring outer;
    std::vector<Ring> holes;

    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// Polygons whose insides do not overlap.
using MultiPolygon = std::vector<Polygon>;

/// Positive for a counter-clockwise ring.
double signedAreaM2(std::span<const Point> ring);

Area area(const Polygon& polygon);
Area area(const MultiPolygon& polygons);

/// Around the outer rings; zero for no polygons.
Bounds bounds(const Polygon& polygon);
Bounds bounds(const MultiPolygon& polygons);

/// The outer rings alone.
MultiPolygon withoutHoles(const MultiPolygon& polygons);

double lengthM(std::span<const Point> line);

/// Even-odd rule; on an edge either answer. Cost: one test of each edge.
bool isInside(std::span<const Point> ring, Point point);
bool isInside(const Polygon& polygon, Point point);
bool isInside(const MultiPolygon& polygons, Point point);

/// The places inside of a grid whose first one is half a step from the lower left corner of the bounds, row
/// by row: those for which `isInside` is true. Cost: one look at each edge for each row.
std::vector<Point> placesInside(const Polygon& polygon, double stepM);

std::size_t vertexCount(const MultiPolygon& polygons);

/// Calls `visit(from, to)` for every edge of every ring, in order.
template <class Visit>
void forEachEdge(const MultiPolygon& polygons, Visit&& visit) {
    const auto walk = [&visit](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            visit(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
        }
    };
    for (const Polygon& polygon : polygons) {
        walk(polygon.outer);
        for (const Ring& hole : polygon.holes) {
            walk(hole);
        }
    }
}

}  // namespace furrow
