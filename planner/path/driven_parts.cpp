#include "planner/path/driven_parts.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>

namespace furrow {

namespace {

// Larger than any distance from the edge of a field.
constexpr Length kWholeField = metres(1e5);

}  // namespace

Result<DrivenParts> DrivenParts::of(const MultiPolygon& drivable, Length breadth, const JobContext& job) {
    return eroded(drivable, 0.5 * breadth, kArcTolerance, job).transform([](const MultiPolygon& rooms) {
        DrivenParts parts;
        for (const Polygon& room : rooms) {
            parts.edges_.emplace_back(MultiPolygon{room}, kWholeField);
        }
        return parts;
    });
}

Result<DrivenParts> DrivenParts::of(const MultiPolygon& drivable, const Machine& machine, Length spare,
                                    const JobContext& job) {
    return of(drivable,
              std::max(machine.spec().tractor.width, machine.turningWidth()) - metres(kNeckContactM) + spare,
              job);
}

bool DrivenParts::separate(Point from, Point to) const {
    return edges_.size() > 1 && partAt(from) != partAt(to);
}

std::size_t DrivenParts::partAt(Point place) const {
    const auto insideM = [&](const BoundaryDistance& edges) {
        return edges.insideM(place).value_or(-kWholeField.si());
    };
    return static_cast<std::size_t>(std::ranges::max_element(edges_, {}, insideM) - edges_.begin());
}

}  // namespace furrow
