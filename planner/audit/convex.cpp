#include "planner/audit/convex.h"

#include "planner/audit/length.h"

#include <algorithm>

namespace furrow {

namespace {

constexpr double kNoAreaM2 = 1e-12;

}  // namespace

std::pair<Ring, Ring> cut(const Ring& ring, Point start, Point along) {
    Ring left;
    Ring right;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& from = ring[i];
        const Point& to = ring[i + 1 == ring.size() ? 0 : i + 1];
        const double a = cross(along, from - start);
        const double b = cross(along, to - start);
        (a >= 0.0 ? left : right).push_back(from);
        if ((a >= 0.0) != (b >= 0.0)) {
            const Point crossing = from + (a / (a - b)) * (to - from);
            left.push_back(crossing);
            right.push_back(crossing);
        }
    }
    return {std::move(left), std::move(right)};
}

// Andrew's monotone chain, forth and back.
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
        const double start =
            cross(side, edge.from - hull[i]) - (depthM > 0.0 ? depthM * lengthOf(side) : 0.0);
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

std::vector<Ring> partsOutside(Ring ring, const Ring& hull) {
    std::vector<Ring> parts;
    for (std::size_t i = 0; i < hull.size() && ring.size() > 2; ++i) {
        auto [inner, outer] = cut(ring, hull[i], hull[(i + 1) % hull.size()] - hull[i]);
        if (outer.size() > 2 && signedAreaM2(outer) > kNoAreaM2) {
            parts.push_back(std::move(outer));
        }
        ring = std::move(inner);
    }
    return parts;
}

}  // namespace furrow
