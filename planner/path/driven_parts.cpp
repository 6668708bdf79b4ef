#include "planner/path/driven_parts.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>

namespace furrow {

namespace {

// Larger than any distance from the edge of a field.
constexpr Length kWholeField = metres(1e5);

}  // namespace

DrivenParts::DrivenParts(const MultiPolygon& rooms) {
    for (const Polygon& room : rooms) {
        edges_.emplace_back(MultiPolygon{room}, kWholeField);
    }
}

Result<DrivenParts> DrivenParts::of(const MultiPolygon& drivable, Length breadth, const JobContext& job) {
    return eroded(drivable, 0.5 * breadth, kArcTolerance, job).transform([](const MultiPolygon& rooms) {
        return DrivenParts{rooms};
    });
}

Result<DrivenParts> DrivenParts::of(const AllowedAreas& areas, const Machine& machine, Length spare,
                                    const JobContext& job) {
    const Length more = spare - metres(kNeckContactM);
    const Length tractor = machine.spec().tractor.width;
    const Length breadth = std::max(tractor, machine.turningWidth());
    if (!areas.hasOverhang()) {
        return of(areas.tractor(), breadth + more, job);
    }
    const auto forTractor = eroded(areas.tractor(), 0.5 * (tractor + more), kArcTolerance, job);
    const auto forImplement = eroded(areas.implement(), 0.5 * (breadth + more), kArcTolerance, job);
    if (!forTractor || !forImplement) {
        return std::unexpected(forTractor ? forImplement.error() : forTractor.error());
    }
    return intersection(*forTractor, *forImplement, job).transform([](const MultiPolygon& rooms) {
        return DrivenParts{rooms};
    });
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
