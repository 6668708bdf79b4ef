#pragma once

#include "planner/geometry/point.h"

#include <algorithm>
#include <utility>

namespace furrow {

/// The point of the segment from a to b that is nearest to p; a where both are one.
inline Point nearestOnSegment(Point p, Point a, Point b) {
    const Point along = b - a;
    const double squared = dot(along, along);
    const double share = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return a + share * along;
}

/// Whether the ray from p along x meets the segment from a to b. Of the edges of a ring an odd number does where p is
/// inside.
inline bool meetsRay(Point p, Point a, Point b) {
    return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
}

inline double distanceToSegment(Point p, Point a, Point b) {
    return distance(p, nearestOnSegment(p, a, b));
}

/// How far ahead of a, and how far behind b, the line from a along `in` meets the one from b along `out`; not finite
/// where they are parallel.
inline std::pair<double, double> toMeeting(Point a, Point in, Point b, Point out) {
    const double sine = cross(in, out);
    return {cross(b - a, out) / sine, cross(in, b - a) / sine};
}

}  // namespace furrow
