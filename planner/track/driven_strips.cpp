#include "planner/track/driven_strips.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace furrow {

namespace {

Polygon counterClockwise(Ring ring) {
    if (signedAreaM2(ring) < 0.0) {
        std::ranges::reverse(ring);
    }
    return {.outer = std::move(ring), .holes = {}};
}

}  // namespace

void addStripsAlong(MultiPolygon& strips, const Polyline& line, double halfM) {
    if (line.empty()) {
        return;
    }
    std::optional<Point> before;  // to the left of the last step
    Point from = line.front();
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Point way = line[i] - from;
        const double length = std::hypot(way.x, way.y);
        if (length < kShortestStepM) {
            continue;
        }
        const Point left{-way.y * halfM / length, way.x * halfM / length};
        strips.push_back(counterClockwise({from + left, from - left, line[i] - left, line[i] + left}));
        if (before) {
            for (const double side : {1.0, -1.0}) {
                Polygon wedge = counterClockwise({from, from + side * *before, from + side * left});
                if (std::abs(signedAreaM2(wedge.outer)) > 1e-6) {
                    strips.push_back(std::move(wedge));
                }
            }
        }
        before = left;
        from = line[i];
    }
}

}  // namespace furrow
