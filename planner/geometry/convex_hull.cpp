#include "planner/geometry/convex_hull.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace furrow {

Ring convexHull(std::span<const Point> points) {
    std::vector<Point> sorted(points.begin(), points.end());
    std::ranges::sort(sorted, [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    Ring hull;
    const auto addChain = [&hull](const auto& chain, std::size_t kept) {
        for (const Point& point : chain) {
            while (hull.size() >= kept + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(point);
        }
        hull.pop_back();  // it begins the other chain
    };
    if (sorted.size() < 3) {
        return sorted;
    }
    addChain(sorted, 0);
    std::ranges::reverse(sorted);
    addChain(sorted, hull.size());
    return hull;
}

bool isConvex(std::span<const Point> ring) {
    // A bend to the right shallower than a tenth of a millimetre is rounding of the coordinates.
    constexpr double kHullSlackM = 1e-4;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i];
        const Point b = ring[(i + 1) % ring.size()];
        const Point c = ring[(i + 2) % ring.size()];
        if (cross(b - a, c - b) < -kHullSlackM * distance(a, c)) {
            return false;
        }
    }
    return ring.size() >= 3;
}

Length minimumWidth(std::span<const Point> hull) {
    if (hull.size() < 3) {
        return metres(0.0);
    }
    double narrowest = std::numeric_limits<double>::infinity();
    std::size_t opposite = 1;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point from = hull[i];
        const Point along = hull[(i + 1) % hull.size()] - from;
        const auto height = [&](std::size_t k) { return cross(along, hull[k % hull.size()] - from); };
        while (height(opposite + 1) > height(opposite)) {
            ++opposite;
        }
        narrowest = std::min(narrowest, height(opposite) / norm(along));
    }
    return metres(narrowest);
}

Length diameter(std::span<const Point> hull) {
    double largest = 0.0;
    for (const Point& a : hull) {
        for (const Point& b : hull) {
            largest = std::max(largest, distance(a, b));
        }
    }
    return metres(largest);
}

}  // namespace furrow
