#include "planner/audit/convex.h"

#include <algorithm>

namespace furrow {

// Andrew's monotone chain, over and back.
Ring hullAround(Ring points) {
    std::ranges::sort(points, [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    Ring hull;
    hull.reserve(points.size() + 2);
    for (int side = 0; side < 2; ++side) {
        const std::size_t base = hull.size();
        for (const Point& point : points) {
            while (hull.size() >= base + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(point);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

std::optional<std::pair<double, double>> partInside(const Ring& hull, const Edge& edge, double depthM) {
    double enter = 0.0;
    double leave = 1.0;
    const Point along = edge.to - edge.from;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point side = hull[(i + 1) % hull.size()] - hull[i];
        const double start = cross(side, edge.from - hull[i]) - (depthM > 0.0 ? depthM * norm(side) : 0.0);
        const double slope = cross(side, along);
        if (slope == 0.0) {
            if (start <= 0.0) {
                return std::nullopt;
            }
        } else if (slope > 0.0) {
            enter = std::max(enter, -start / slope);
        } else {
            leave = std::min(leave, -start / slope);
        }
        if (enter >= leave) {
            return std::nullopt;
        }
    }
    return std::pair{enter, leave};
}

}  // namespace furrow
