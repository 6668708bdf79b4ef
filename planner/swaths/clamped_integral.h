#pragma once

#include "planner/geometry/point.h"

#include <algorithm>

namespace furrow {

/// A stretch along a track, metres.
struct Interval {
    double from = 0.0;
    double to = 0.0;
};

/// The integral of clamp(u, 0, span) over u, from minus infinity.
inline double clampedArea(double u, double span) {
    const double inside = std::min(std::max(u, 0.0), span);
    return 0.5 * inside * inside + span * (std::max(u, span) - span);
}

/// The integral of clamp(x, from, to) - from over y along a straight edge, with y from y0 to y1.
inline double clampedIntegral(Point p0, Point p1, Interval interval) {
    const double span = interval.to - interval.from;
    const double u0 = p0.x - interval.from;
    const double u1 = p1.x - interval.from;
    const double dy = p1.y - p0.y;
    const double low = std::min(u0, u1);
    const double high = std::max(u0, u1);
    if (high <= 0.0) {
        return 0.0;
    }
    if (low >= span) {
        return span * dy;
    }
    if (low >= 0.0 && high <= span) {
        return 0.5 * (u0 + u1) * dy;
    }
    // The edge meets a swath's end. These are the shares of its length below, within and beyond the clamp.
    const double length = high - low;
    const double within = std::min(high, span) - std::max(low, 0.0);
    const double beyond = std::max(high - span, 0.0);
    const double middle = 0.5 * (std::min(high, span) + std::max(low, 0.0));
    return dy * (within * middle + beyond * span) / length;
}

}  // namespace furrow
