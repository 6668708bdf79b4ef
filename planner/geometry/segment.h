#pragma once

#include "planner/geometry/point.h"

#include <algorithm>
#include <utility>

namespace furrow {

/// The point of the segment from a to b nearest to p. It is a if a and b are the same.
inline Point nearestOnSegment(Point p, Point a, Point b) {
    const Point along = b - a;
    const double squared = dot(along, along);
    const double share = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return a + share * along;
}

/// Whether the ray from p along x meets the segment from a to b. If p is inside a ring, the ray meets an odd
/// number of its edges.
inline bool meetsRay(Point p, Point a, Point b) {
    return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
}

inline double distanceToSegment(Point p, Point a, Point b) {
    return distance(p, nearestOnSegment(p, a, b));
}

/// The line from a along `in` meets the line from b along `out`. Returns the distance of that point ahead of
/// a, and behind b. Not finite if they are parallel.
inline std::pair<double, double> toMeeting(Point a, Point in, Point b, Point out) {
    const double sine = cross(in, out);
    return {cross(b - a, out) / sine, cross(in, b - a) / sine};
}

}  // namespace furrow
