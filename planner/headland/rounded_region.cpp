#include "planner/headland/rounded_region.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/headland/ring_bend.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

namespace {

/// The area that discs of the radius inside the polygons can cover: outward corners are rounded, necks cut.
Result<MultiPolygon> opened(const MultiPolygon& polygons, Length radius, const JobContext& job) {
    return eroded(polygons, radius, kRoundTolerance, job).and_then([&](const MultiPolygon& core) {
        return dilated(core, radius, kRoundTolerance, job);
    });
}

Polygon disc(Point centre, double radiusM) {
    const double cosine = 1.0 - kRoundTolerance.si() / radiusM;
    const int corners = std::max(16, static_cast<int>(std::ceil(std::numbers::pi / std::acos(cosine))));
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        polygon.outer.push_back(centre + radiusM * direction(2.0 * std::numbers::pi * i / corners));
    }
    return polygon;
}

/// Discs of the radius that touch the corners pointing into the region. The region without them can be driven
/// around.
MultiPolygon discsAtInwardCorners(const Polygon& region, double radiusM) {
    MultiPolygon discs;
    const auto visit = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Bend bend = bendAt(ring, i);
            // The distance that the disc sticks out of the edges. A smaller one needs no disc.
            if (bend.turnRad < 0.0 && radiusM * (1.0 - std::cos(0.5 * bend.turnRad)) > kRoundTolerance.si()) {
                discs.push_back(disc(ring[i] - radiusM * bend.inward, radiusM));
            }
        }
    };
    visit(region.outer);
    std::ranges::for_each(region.holes, visit);
    return discs;
}

}  // namespace

Result<MultiPolygon> roundedRegion(const Polygon& region, Length radius, const JobContext& job) {
    const MultiPolygon discs = discsAtInwardCorners(region, radius.si());
    Result<MultiPolygon> left = MultiPolygon{region};
    if (!discs.empty()) {
        left = unionOf(discs, job).and_then([&](const MultiPolygon& taken) {
            return difference({region}, taken, job);
        });
    }
    return left.and_then([&](const MultiPolygon& polygons) { return opened(polygons, radius, job); });
}

}  // namespace furrow
