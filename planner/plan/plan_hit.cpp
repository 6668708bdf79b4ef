#include "planner/plan/plan_hit.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/geometry/segment.h"

namespace furrow {

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

}  // namespace furrow
