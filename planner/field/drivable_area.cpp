#include "planner/field/drivable_area.h"

#include "planner/geometry/geos_bridge.h"

#include <algorithm>
#include <iterator>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

/// A disc around every gate. Within it the footprint may cross the boundary.
MultiPolygon openGates(const Field& field) {
    constexpr int kCorners = 32;
    MultiPolygon discs;
    for (const Gate& gate : field.source().gates) {
        const Point centre = field.frame().toLocal(gate.position);
        Polygon disc;
        for (int i = 0; i < kCorners; ++i) {
            disc.outer.push_back(centre +
                                 0.5 * gate.width.si() * direction(2.0 * std::numbers::pi * i / kCorners));
        }
        discs.push_back(std::move(disc));
    }
    return discs;
}

Result<MultiPolygon> within(const MultiPolygon& land, const Field& field, Length margin,
                            const JobContext& job) {
    auto area = margin > metres(0.0) ? eroded(land, margin, kArcTolerance, job) : Result<MultiPolygon>{land};
    if (!area || field.source().gates.empty()) {
        return area;
    }
    std::ranges::move(openGates(field), std::back_inserter(*area));
    return unionOf(*area, job);
}

}  // namespace

Result<MultiPolygon> drivableArea(const Field& field, Length margin, const JobContext& job) {
    return within(field.drivable(), field, margin, job);
}

Result<AllowedAreas> allowedAreas(const Field& field, const std::optional<MultiPolygon>& overhung,
                                  Length margin, const JobContext& job) {
    auto tractor = drivableArea(field, margin, job);
    if (!tractor || !overhung) {
        return std::move(tractor).transform(
            [](MultiPolygon&& both) { return AllowedAreas{std::move(both)}; });
    }
    return within(*overhung, field, margin, job).transform([&](MultiPolygon&& implement) {
        return AllowedAreas{*std::move(tractor), std::move(implement)};
    });
}

}  // namespace furrow
