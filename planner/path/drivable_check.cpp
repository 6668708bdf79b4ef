#include "planner/path/drivable_check.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/jobs/parallel.h"
#include "planner/turns/footprint_check.h"
#include "planner/turns/turn_sampling.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// Places along a headland pass where the footprint is looked at lie no farther apart.
constexpr Length kPassStep = metres(0.5);
// Taken off the footprint all round, so that touching the edge up to rounding is staying inside.
constexpr double kTouchingM = 1e-3;

Ring shrunken(Ring footprint) {
    for (Point& corner : footprint) {
        corner.x -= std::copysign(kTouchingM, corner.x);
        corner.y -= std::copysign(kTouchingM, corner.y);
    }
    return footprint;
}

/// A disc drawn around every gate: within it the footprint may cross the boundary.
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

/// The same without holes: what lies outside of this lies outside the field.
MultiPolygon withoutHoles(const MultiPolygon& polygons) {
    MultiPolygon filled;
    for (const Polygon& polygon : polygons) {
        filled.push_back({.outer = polygon.outer, .holes = {}});
    }
    return filled;
}

/// The outline of the footprint at every sample.
std::vector<Polyline> outlinesAlong(const PathSegment& segment, const Ring& footprint) {
    std::vector<Polyline> outlines;
    for (const PathSample& sample : segment.samples) {
        outlines.push_back(
            placed(footprint, {.position = sample.position, .heading = radians(sample.headingRad)}));
        outlines.back().push_back(outlines.back().front());
    }
    return outlines;
}

/// The lines that the corners of these outlines draw from one to the next.
std::vector<Polyline> cornerTracks(const std::vector<Polyline>& outlines) {
    std::vector<Polyline> tracks(outlines.front().size() - 1);
    for (const Polyline& outline : outlines) {
        for (std::size_t corner = 0; corner < tracks.size(); ++corner) {
            tracks[corner].push_back(outline[corner]);
        }
    }
    return tracks;
}

/// Whether a corner of the footprint gets outside along a pass that begins inside: a pass is too long to be drawn
/// outline by outline.
bool leavesAlong(const PathSegment& pass, const Ring& footprint, const BoundaryDistance& edges) {
    for (std::size_t i = 0; i + 1 < pass.samples.size(); ++i) {
        const PathSample& from = pass.samples[i];
        const PathSample& to = pass.samples[i + 1];
        const Turn step{.type = {},
                        .start = {.position = from.position, .heading = radians(from.headingRad)},
                        .pieces = {{.length = metres(to.sM - from.sM),
                                    .curvature = Curvature::fromSi(from.curvature1pm),
                                    .endCurvature = Curvature::fromSi(from.curvature1pm),
                                    .gear = pass.gear}}};
        if (!staysInside(step, footprint, edges, kPassStep)) {
            return true;
        }
    }
    return false;
}

}  // namespace

Result<MultiPolygon> drivableArea(const Field& field, Length margin, const JobContext& job) {
    auto area = margin > metres(0.0) ? eroded(field.drivable(), margin, kArcTolerance, job)
                                     : Result<MultiPolygon>{field.drivable()};
    if (!area || field.source().gates.empty()) {
        return area;
    }
    std::ranges::move(openGates(field), std::back_inserter(*area));
    return unionOf(*area, job);
}

Result<std::vector<BlockedConnection>> blockedConnections(const Path& path, const Field& field,
                                                          const Machine& machine, Length margin,
                                                          const JobContext& job) {
    const auto area = drivableArea(field, margin, job);
    if (!area) {
        return std::unexpected(area.error());
    }
    const PreparedArea drivable{*area};
    const PreparedArea land{withoutHoles(*area)};
    const BoundaryDistance edges{*area, machine.workingFootprintWidth() + machine.spec().tractor.length};
    const Ring raised = shrunken(machine.turningFootprint());
    const Ring lowered = shrunken(machine.workingFootprint());
    std::vector<std::size_t> connections;
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        if (path.segments[i].kind != SegmentKind::Swath) {
            connections.push_back(i);
        }
    }
    const auto checked = parallelMap<std::optional<BlockedConnection>>(
        connections.size(),
        [&](std::size_t i) -> std::optional<BlockedConnection> {
            const PathSegment& segment = path.segments[connections[i]];
            if (segment.kind == SegmentKind::HeadlandPass && !leavesAlong(segment, lowered, edges)) {
                return std::nullopt;
            }
            const auto outlines = outlinesAlong(segment, segment.implementDown ? lowered : raised);
            // Along a straight or bulging boundary the hull decides; only inward corners need more.
            if (drivable.coversHullOf(outlines)) {
                return std::nullopt;
            }
            const auto tracks = cornerTracks(outlines);
            const bool tracksInside = drivable.covers(tracks);
            if (tracksInside && drivable.covers(outlines)) {
                return std::nullopt;
            }
            BlockedConnection blocked{.segment = connections[i]};
            // A footprint is farthest out with one of its corners, unless it straddles what is in the way.
            const auto& lines = tracksInside ? outlines : tracks;
            const auto beyondLand = land.farthestOutside(lines);
            blocked.obstacle = !beyondLand;
            const auto farthest = beyondLand ? beyondLand : drivable.farthestOutside(lines);
            // Outside by less than rounding can tell: covered after all.
            if (!farthest) {
                return std::nullopt;
            }
            blocked.place = farthest->point;
            blocked.outside = farthest->distance;
            return blocked;
        },
        job);
    if (!checked) {
        return std::unexpected(checked.error());
    }
    std::vector<BlockedConnection> found;
    for (const auto& blocked : *checked) {
        if (blocked) {
            found.push_back(*blocked);
        }
    }
    return found;
}

}  // namespace furrow
