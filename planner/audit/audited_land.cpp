#include "planner/audit/audited_land.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

constexpr double kReachToleranceM = 0.02;

/// The radius of the disc that has to fit where a machine can work: half its footprint's width. A machine
/// that cannot reverse out of a corner can at best go round it on full lock. The outer end of its implement
/// then describes the edge of its reach.
Length reachRadius(const Machine& machine, const MachineShape& shape) {
    const MachineSpec& spec = machine.spec();
    const Length half = 0.5 * machine.workingFootprintWidth();
    if (spec.tractor.canTurnInPlace ||
        (spec.tractor.canReverse && (!shape.trailingM || spec.implement.canReverse))) {
        return half;
    }
    double radiusM = machine.minTurningRadius().si();
    if (shape.trailingM) {
        const double hitchM = std::hypot(radiusM, shape.hitchOffsetM);
        radiusM = std::sqrt(std::max(0.0, hitchM * hitchM - *shape.trailingM * *shape.trailingM));
    }
    return half + metres(radiusM);
}

/// The drivable area less the margin.
Result<MultiPolygon> withinMargin(const AuditInput& input, const JobContext& job) {
    return input.margin > Length{} ? eroded(input.drivable, input.margin, kArcTolerance, job)
                                   : Result<MultiPolygon>{input.drivable};
}

/// The distance by which a tractor that is broader than its implement keeps the working line away from an
/// edge, along it and across it.
Length keptAway(const Machine& machine, const MachineShape& shape) {
    if (shape.trailingM) {
        return {};
    }
    const Length lineAt = machine.spec().implement.offset;
    Length front = lineAt;
    Length rear = lineAt;
    for (const Point& corner : machine.workingFootprint()) {
        front = std::max(front, metres(corner.x));
        rear = std::min(rear, metres(corner.x));
    }
    const Length aside = 0.5 * (machine.workingFootprintWidth() - machine.operatingWidth());
    return std::max(Length{}, std::min({aside, front - lineAt, lineAt - rear}));
}

/// The area in which that disc fits, less the strip from which the tractor keeps the working line away.
Result<MultiPolygon> reachable(const AuditInput& input, const MultiPolygon& area, const MachineShape& shape,
                               const JobContext& job) {
    const Length radius = reachRadius(*input.machine, shape);
    const auto middles = eroded(area, radius, metres(kReachToleranceM), job);
    return middles
               ? dilated(*middles, radius - keptAway(*input.machine, shape), metres(kReachToleranceM), job)
               : middles;
}

MultiPolygon gateDiscs(const std::vector<AuditGate>& gates) {
    constexpr int kCorners = 64;
    MultiPolygon discs;
    for (const AuditGate& gate : gates) {
        Ring ring;
        for (int i = 0; i < kCorners && gate.width > metres(0.0); ++i) {
            ring.push_back(gate.position +
                           0.5 * gate.width.si() * direction(2.0 * std::numbers::pi * i / kCorners));
        }
        if (!ring.empty()) {
            discs.push_back({.outer = std::move(ring), .holes = {}});
        }
    }
    return discs;
}

/// An area with the gates open.
Result<MultiPolygon> withGates(const AuditInput& input, MultiPolygon open, const JobContext& job) {
    const MultiPolygon discs = gateDiscs(input.gates);
    if (discs.empty()) {
        return open;
    }
    std::ranges::copy(discs, std::back_inserter(open));
    return unionOf(open, job, kSnapGrid);
}

}  // namespace

OpenLand::OpenLand(MultiPolygon area) : open{std::move(area)}, meter{open, withoutHoles(open)} {}

Result<ClearanceLand> clearanceLand(const AuditInput& input, const JobContext& job) {
    auto open = withGates(input, input.drivable, job);
    if (!open) {
        return std::unexpected(open.error());
    }
    ClearanceLand land{.drivable = OpenLand{*std::move(open)}, .overhung = {}};
    if (input.overhung) {
        auto wider = withGates(input, *input.overhung, job);
        if (!wider) {
            return std::unexpected(wider.error());
        }
        land.overhung.emplace(*std::move(wider));
    }
    return land;
}

Result<AuditedLand> auditedLand(const AuditInput& input, const JobContext& job) {
    auto within = withinMargin(input, job);
    if (!within) {
        return std::unexpected(within.error());
    }
    AuditedLand land{.withinMargin = *std::move(within), .reach = {}, .clearance = {}, .room = {}};
    if (!input.machine) {
        return land;
    }
    const MachineShape shape = shapeOf(input);
    if (!shape.trailingM) {
        land.room.emplace(land.withinMargin, *input.machine, shape);
    }
    auto reach = reachable(input, land.withinMargin, shape, job);
    if (!reach) {
        return std::unexpected(reach.error());
    }
    land.reach = *std::move(reach);
    auto clearance = clearanceLand(input, job);
    if (!clearance) {
        return std::unexpected(clearance.error());
    }
    land.clearance = *std::move(clearance);
    return land;
}

}  // namespace furrow
