#include "planner/plan/plan_hit.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/geometry/segment.h"

#include <algorithm>

namespace furrow {

namespace {

constexpr double kSameEndM = 0.5;

}  // namespace

std::optional<std::size_t> segmentAt(const Plan& plan, Point place, Length reach) {
    std::optional<std::size_t> best;
    double nearest = reach.si();
    for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
        const auto& samples = plan.path.segments[i].samples;
        for (std::size_t k = 1; k < samples.size(); ++k) {
            const double away = distanceToSegment(place, samples[k - 1].position, samples[k].position);
            if (away <= nearest) {
                nearest = away;
                best = i;
            }
        }
    }
    return best;
}

std::optional<std::size_t> cellAt(const Plan& plan, Point place) {
    const std::vector<Polyline> there{{place, place + Point{1e-6, 0.0}}};
    const auto& cells = plan.cells.cells;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (PreparedArea{cells[i].outline}.covers(there)) {
            return i;
        }
    }
    return std::nullopt;
}

std::optional<std::size_t> sameStretch(const PathSegment& segment, const Path& path) {
    const Point begin = segment.samples.front().position;
    const Point end = segment.samples.back().position;
    const auto isSame = [&](const PathSegment& other) {
        const Point otherBegin = other.samples.front().position;
        const Point otherEnd = other.samples.back().position;
        const auto areNear = [](Point a, Point b) { return distance(a, b) < kSameEndM; };
        return other.kind == segment.kind && ((areNear(begin, otherBegin) && areNear(end, otherEnd)) ||
                                              (areNear(begin, otherEnd) && areNear(end, otherBegin)));
    };
    const auto same = std::ranges::find_if(path.segments, isSame);
    return same == path.segments.end()
               ? std::nullopt
               : std::optional{static_cast<std::size_t>(same - path.segments.begin())};
}

}  // namespace furrow
