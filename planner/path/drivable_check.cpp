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
// Passes lie along the edge: what they are outside by less is drawing.
constexpr Length kPassReserve = metres(0.005);
// Taken off the footprint all round, so that touching the edge up to rounding is staying inside.
constexpr double kTouchingM = 1e-3;

Ring shrunken(Ring footprint) {
    for (Point& corner : footprint) {
        corner.x -= std::copysign(kTouchingM, corner.x);
        corner.y -= std::copysign(kTouchingM, corner.y);
    }
    return footprint;
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

/// Where a footprint gets farthest outside along a headland pass; nothing where it stays inside. A pass is too long
/// to be drawn outline by outline. Ends early, with something, where the job is stopped.
std::optional<BlockedConnection> farthestAlong(const PathSegment& pass, const Ring& footprint,
                                               const BoundaryDistance& drivable, const BoundaryDistance& land,
                                               const JobContext& job) {
    BlockedConnection farthest;
    Pose worst;
    for (std::size_t i = 0; i + 1 < pass.samples.size() && !job.stopRequested(); ++i) {
        const PathSample& from = pass.samples[i];
        const Pose start{.position = from.position, .heading = radians(from.headingRad)};
        const Length way = metres(pass.samples[i + 1].sM - from.sM);
        const Curvature curvature = Curvature::fromSi(from.curvature1pm);
        const TurnPiece piece{.length = way, .curvature = curvature, .endCurvature = curvature, .gear = pass.gear};
        const auto steps = std::max(1, static_cast<int>(std::ceil(way / kPassStep)));
        for (int k = 0; k < steps; ++k) {
            const Pose pose = advanced(start, piece, way * (static_cast<double>(k) / steps));
            if (const Length outside = metres(outsideM(pose, footprint, drivable)); outside > farthest.outside) {
                farthest.outside = outside;
                worst = pose;
            }
        }
    }
    if (farthest.outside <= kPassReserve) {
        return std::nullopt;
    }
    farthest.place = worst.position;
    farthest.obstacle = outsideM(worst, footprint, land) == 0.0;
    return farthest;
}

}  // namespace

Result<std::vector<BlockedConnection>> blockedConnections(const Path& path, const MultiPolygon& drivableArea,
                                                          const Machine& machine, const JobContext& job) {
    const MultiPolygon landArea = withoutHoles(drivableArea);
    const PreparedArea drivable{drivableArea};
    const PreparedArea land{landArea};
    const Length reach = machine.workingFootprintWidth() + machine.spec().tractor.length;
    const BoundaryDistance drivableEdges{drivableArea, reach};
    const BoundaryDistance landEdges{landArea, reach};
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
            if (segment.kind == SegmentKind::HeadlandPass) {
                auto found = farthestAlong(segment, lowered, drivableEdges, landEdges, job);
                if (found) {
                    found->segment = connections[i];
                }
                return found;
            }
            const auto outlines = outlinesAlong(segment, raised);
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
