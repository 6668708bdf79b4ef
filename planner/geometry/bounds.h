#pragma once

#include "planner/geometry/point.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace furrow {

/// A box along the axes, in metres.
struct Bounds {
    Point min;
    Point max;

    double width() const { return max.x - min.x; }
    double height() const { return max.y - min.y; }

    friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// Around an edge, or any two points.
inline Bounds bounds(Point a, Point b) {
    return {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
}

/// Around both boxes.
inline Bounds joined(const Bounds& a, const Bounds& b) {
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

/// Around all points; zero for none.
inline Bounds bounds(std::span<const Point> points) {
    if (points.empty()) {
        return {};
    }
    Bounds box{points.front(), points.front()};
    for (const Point& point : points) {
        box = joined(box, {point, point});
    }
    return box;
}

/// Moves each side outwards.
inline Bounds widened(const Bounds& box, double byM) {
    return {box.min - Point{byM, byM}, box.max + Point{byM, byM}};
}

/// Whether two boxes share a point.
inline bool meet(const Bounds& a, const Bounds& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y;
}

/// On a side counts, too.
inline bool contains(const Bounds& box, Point point) {
    return meet(box, {point, point});
}

/// The distance from a point to the nearest point of a box; 0 inside.
inline double distanceM(Point point, const Bounds& box) {
    return std::hypot(std::max({box.min.x - point.x, 0.0, point.x - box.max.x}),
                      std::max({box.min.y - point.y, 0.0, point.y - box.max.y}));
}

}  // namespace furrow
