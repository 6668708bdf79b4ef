#include "planner/path/refill_stops.h"

#include "planner/geometry/segment.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace furrow {

namespace {

// Length of the straight on which the machine draws up.
constexpr Length kDrawUp = metres(2.0);
constexpr double kStopStepM = 0.25;
constexpr int kDirections = 24;
constexpr double kLengthsOff = 2.0;
// Aside from the edge, if the machine fits in neither direction along it.
constexpr std::array kStopAsideDeg{30.0, -30.0, 60.0, -60.0, 90.0, -90.0, 120.0, -120.0, 150.0, -150.0};

/// The direction of the edge that is nearest to a place.
Angle alongEdge(Point place, const Field& field) {
    double nearest = std::numeric_limits<double>::infinity();
    Point along{1.0, 0.0};
    forEachEdge(field.drivable(), [&](Point a, Point b) {
        if (const double away = distanceToSegment(place, a, b);
            away < nearest && distance(a, b) > kContactM) {
            nearest = away;
            along = b - a;
        }
    });
    return radians(std::atan2(along.y, along.x));
}

/// The straight that ends at a place, if the machine fits there.
std::optional<Leg> drawnUpAt(Point place, Angle heading, const Rig& rig) {
    const CurvePiece straight{.length = kDrawUp, .curvature = {}};
    const Pose start{.position = place - kDrawUp.si() * direction(heading.si()), .heading = heading};
    if (rig.outsideM(Rig::inLine({place, heading})) > kContactM ||
        rig.outsideM(Rig::inLine(start)) > kContactM || !rig.driven(Rig::inLine(start), straight)) {
        return std::nullopt;
    }
    return Leg{.kind = SegmentKind::Refill,
               .number = 0,
               .line = {.type = {}, .start = start, .pieces = {straight}},
               .implementDown = false,
               .refills = true};
}

/// At one place, all headings that fit.
std::vector<Leg> drawnUp(Point place, Angle along, std::span<const double> asideDeg, const Rig& rig) {
    std::vector<Leg> stops;
    for (const double aside : asideDeg) {
        if (auto stop = drawnUpAt(place, along + degrees(aside), rig)) {
            stops.push_back(*std::move(stop));
        }
    }
    return stops;
}

}  // namespace

Length refillReach(const Machine& machine) {
    return kLengthsOff * machine.spec().tractor.length + 0.5 * machine.turningWidth();
}

std::vector<Leg> refillStops(const RoutePlace& place, const Field& field, const Rig& rig) {
    const Angle along = alongEdge(place.position, field);
    constexpr std::array kAlongDeg{0.0, 180.0};
    const double mostM = refillReach(rig.machine()).si();
    std::vector<Leg> aside;
    for (double offM = 0.0; offM <= mostM; offM += kStopStepM) {
        // The first of the directions is that across the edge.
        for (int i = 0; i < (offM > 0.0 ? kDirections : 1); ++i) {
            const double turned = 0.5 * std::numbers::pi + 2.0 * std::numbers::pi * i / kDirections;
            const Point at = place.position + offM * direction(along.si() + turned);
            if (auto stops = drawnUp(at, along, kAlongDeg, rig); !stops.empty()) {
                return stops;
            }
            if (aside.empty()) {
                aside = drawnUp(at, along, kStopAsideDeg, rig);
            }
        }
    }
    return aside;
}

}  // namespace furrow
