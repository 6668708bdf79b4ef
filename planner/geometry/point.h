#pragma once

#include <cmath>

namespace furrow {

/// A place or a displacement in a local frame: metres, x to the east, y to the north.
struct Point {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const Point&, const Point&) = default;
    friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
};

constexpr double dot(Point a, Point b) {
    return a.x * b.x + a.y * b.y;
}

/// Positive if b lies to the left of a.
constexpr double cross(Point a, Point b) {
    return a.x * b.y - a.y * b.x;
}

inline double norm(Point a) {
    // Fields are small enough to square their coordinates. hypot() guards against overflow and takes five
    // times as long.
    return std::sqrt(a.x * a.x + a.y * a.y);
}

inline double distance(Point a, Point b) {
    return norm(b - a);
}

/// The unit vector of a heading in radians.
inline Point direction(double headingRad) {
    return {std::cos(headingRad), std::sin(headingRad)};
}

}  // namespace furrow
