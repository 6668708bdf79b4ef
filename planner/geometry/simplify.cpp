#include "planner/geometry/simplify.h"

#include "planner/geometry/segment.h"

#include <algorithm>
#include <utility>

namespace furrow {

Polyline simplified(const Polyline& line, Length tolerance) {
    if (line.size() < 3) {
        return line;
    }
    std::vector<bool> stays(line.size(), false);
    stays.front() = stays.back() = true;
    // An explicit stack. With recursion, long spirals would nest as deep as their number of points.
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        double farthest = tolerance.si();
        std::size_t at = first;
        for (std::size_t i = first + 1; i < last; ++i) {
            if (const double beside = distanceToSegment(line[i], line[first], line[last]);
                beside > farthest) {
                farthest = beside;
                at = i;
            }
        }
        if (at != first) {
            stays[at] = true;
            open.emplace_back(first, at);
            open.emplace_back(at, last);
        }
    }
    Polyline kept;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (stays[i]) {
            kept.push_back(line[i]);
        }
    }
    return kept;
}

Ring simplifiedRing(Ring ring, Length tolerance) {
    ring.push_back(ring.front());
    Ring kept = simplified(ring, tolerance);
    kept.pop_back();
    return kept;
}

}  // namespace furrow
