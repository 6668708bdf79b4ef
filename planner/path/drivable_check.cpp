#include "planner/path/drivable_check.h"

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"
#include "planner/path/folded_stretches.h"
#include "planner/turns/footprint_check.h"
#include "planner/turns/rig.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace furrow {

namespace {

// Largest distance between places along a headland pass at which the footprint is tested.
constexpr Length kPassStep = metres(0.5);
constexpr Length kAnyStep = metres(1e6);
// A trailed implement with a smaller angle to the tractor is in line.
constexpr double kInLineRad = 1e-3;
// Over shorter ways, rounding of headings hides the curvature.
constexpr double kShortestWayM = 1e-3;
constexpr double kSameTurnRad = 1e-9;
// A smaller excess of passes and ways along the edge comes from drawing, as in the audit.
constexpr Length kDrawing = metres(0.01);

Ring shrunken(Ring footprint) {
    for (Point& corner : footprint) {
        corner.x -= std::copysign(kContactM, corner.x);
        corner.y -= std::copysign(kContactM, corner.y);
    }
    return footprint;
}

/// The same without holes. A place outside this area lies outside the field.
MultiPolygon withoutHoles(const MultiPolygon& polygons) {
    MultiPolygon filled;
    for (const Polygon& polygon : polygons) {
        filled.push_back({.outer = polygon.outer, .holes = {}});
    }
    return filled;
}

/// The driven shapes, slightly reduced: one shape, or a tractor and its trailed implement.
struct Shapes {
    explicit Shapes(const Machine& machine)
        : trailer{Trailer::of(machine)},
          tractor{shrunken(tractorOutline(machine))},
          raised{shrunken(trailer ? trailer->raised : machine.turningFootprint())},
          lowered{shrunken(trailer ? trailer->lowered : machine.workingFootprint())} {}

    const Ring& implement(bool down) const { return down ? lowered : raised; }

    std::optional<Trailer> trailer;
    Ring tractor;  ///< only used with a trailer
    Ring raised;   ///< including the tractor if there is no trailer
    Ring lowered;
};

/// The curvature just before the second of two samples. A sample states the one after it, so this follows
/// from the turn between them.
Curvature endCurvature(const PathSample& from, const PathSample& to, Gear gear) {
    const double wayM = to.sM - from.sM;
    if (wayM < kShortestWayM) {
        return Curvature::fromSi(from.curvature1pm);
    }
    const double turned = std::remainder(to.headingRad - from.headingRad, 2.0 * std::numbers::pi);
    // Straights and arcs stay what they are.
    const double bent = (gear == Gear::Forward ? 1.0 : -1.0) * turned / wayM;
    if (std::abs(bent - from.curvature1pm) * wayM < kSameTurnRad) {
        return Curvature::fromSi(from.curvature1pm);
    }
    return Curvature::fromSi(2.0 * bent - from.curvature1pm);
}

/// The states of tractor and implement along a segment: at every sample, no farther apart than `step`, and
/// close together while a trailed implement is not in line. `implement` continues from segment to segment.
std::vector<RigState> statesAlong(const PathSegment& segment, const Shapes& shapes, Length step,
                                  Angle& implement) {
    std::vector<RigState> states;
    const auto poseAt = [](const PathSample& sample) {
        return Pose{.position = sample.position, .heading = radians(sample.headingRad)};
    };
    states.push_back({poseAt(segment.samples.front()), implement});
    for (std::size_t i = 1; i < segment.samples.size(); ++i) {
        const PathSample& from = segment.samples[i - 1];
        const Pose start = poseAt(from);
        const Length way = metres(segment.samples[i].sM - from.sM);
        const Curvature curvature = Curvature::fromSi(from.curvature1pm);
        const CurvePiece piece{.length = way,
                               .curvature = curvature,
                               .endCurvature = endCurvature(from, segment.samples[i], segment.gear),
                               .gear = segment.gear};
        // At least once: on the spot only the heading changes.
        Length gone;
        do {
            Length next = std::min(way, gone + step);
            if (shapes.trailer) {
                const double askew =
                    std::remainder((implement - states.back().tractor.heading).si(), 2.0 * std::numbers::pi);
                if (std::abs(askew) > kInLineRad || curvature != Curvature{} ||
                    piece.endCurvature != Curvature{}) {
                    next = std::min(next, gone + shapes.trailer->longestStep());
                }
            }
            const Pose pose = next == way ? poseAt(segment.samples[i]) : advanced(start, piece, next);
            implement = shapes.trailer ? shapes.trailer->headingAfter(implement, states.back().tractor, pose)
                                       : pose.heading;
            states.push_back({pose, implement});
            gone = next;
        } while (gone < way);
    }
    return states;
}

/// The outlines of one shape along the way.
std::vector<Polyline> outlines(std::span<const RigState> states, const Ring& shape,
                               const std::optional<Trailer>& trailer) {
    std::vector<Polyline> all;
    for (const RigState& state : states) {
        all.push_back(
            placed(shape, trailer ? trailer->poseOf(state.tractor, state.implement) : state.tractor));
        all.back().push_back(all.back().front());
    }
    return all;
}

/// The lines that the corners of these outlines draw from one outline to the next.
std::vector<Polyline> cornerTracks(const std::vector<Polyline>& outlines) {
    std::vector<Polyline> tracks(outlines.front().size() - 1);
    for (const Polyline& outline : outlines) {
        for (std::size_t corner = 0; corner < tracks.size(); ++corner) {
            tracks[corner].push_back(outline[corner]);
        }
    }
    return tracks;
}

/// The distance that the machine is outside.
double outsideM(const RigState& state, const Shapes& shapes, const BoundaryDistance& edges) {
    if (!shapes.trailer) {
        return outsideM(state.tractor, shapes.lowered, edges);
    }
    return std::max(outsideM(state.tractor, shapes.tractor, edges),
                    outsideM(shapes.trailer->poseOf(state.tractor, state.implement), shapes.lowered, edges));
}

/// The place where a headland pass is farthest outside. Empty if it stays inside. A pass is too long for a
/// test by outlines. Ends early, with a partial result, if the job is stopped.
std::optional<BlockedConnection> farthestAlong(std::span<const RigState> states, const Shapes& shapes,
                                               const BoundaryDistance& drivable, const BoundaryDistance& land,
                                               const JobContext& job) {
    BlockedConnection farthest;
    RigState worst;
    for (const RigState& state : states) {
        if (job.stopRequested()) {
            break;
        }
        if (const Length outside = metres(outsideM(state, shapes, drivable)); outside > farthest.outside) {
            farthest.outside = outside;
            worst = state;
        }
    }
    if (farthest.outside <= kDrawing) {
        return std::nullopt;
    }
    farthest.place = worst.tractor.position;
    farthest.obstacle = outsideM(worst, shapes, land) == 0.0;
    return farthest;
}

/// The place where the area swept between two stretches of work is farthest outside. Empty if it stays
/// inside.
std::optional<BlockedConnection> farthestOnWay(std::span<const RigState> states, const Shapes& shapes,
                                               bool lowered, const PreparedArea& drivable,
                                               const PreparedArea& land) {
    std::vector<Polyline> all = outlines(states, shapes.implement(lowered), shapes.trailer);
    std::vector<Polyline> tracks = cornerTracks(all);
    if (shapes.trailer) {
        const std::vector<Polyline> tractor = outlines(states, shapes.tractor, std::nullopt);
        std::ranges::move(cornerTracks(tractor), std::back_inserter(tracks));
        std::ranges::copy(tractor, std::back_inserter(all));
    }
    // Along a straight or bulging boundary the hull decides. Only inward corners need more.
    if (drivable.coversHullOf(all)) {
        return std::nullopt;
    }
    const bool tracksInside = drivable.covers(tracks);
    if (tracksInside && drivable.covers(all)) {
        return std::nullopt;
    }
    BlockedConnection blocked;
    // A footprint is farthest out with one of its corners, unless it straddles the obstacle.
    const std::vector<Polyline>& lines = tracksInside ? all : tracks;
    const auto beyondLand = land.farthestOutside(lines);
    blocked.obstacle = !beyondLand;
    const auto farthest = beyondLand ? beyondLand : drivable.farthestOutside(lines);
    // A smaller excess may come from drawing, so the area counts as covered.
    if (!farthest || farthest->distance <= kDrawing) {
        return std::nullopt;
    }
    blocked.place = farthest->point;
    blocked.outside = farthest->distance;
    return blocked;
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
    const Shapes shapes{machine};
    const Shapes folded{machine.folded()};
    struct Connection {
        std::size_t segment;
        std::vector<RigState> states;
    };
    std::vector<Connection> connections;
    Angle implement =
        path.segments.empty() ? Angle{} : radians(path.segments.front().samples.front().headingRad);
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        const PathSegment& segment = path.segments[i];
        // Swaths are followed as well, since the implement trails on from one segment to the next.
        std::vector<RigState> states = statesAlong(
            segment, shapes, segment.kind == SegmentKind::HeadlandPass ? kPassStep : kAnyStep, implement);
        if (segment.kind != SegmentKind::Swath) {
            connections.push_back({i, std::move(states)});
        }
    }
    const auto checked = parallelMap<std::optional<BlockedConnection>>(
        connections.size(),
        [&](std::size_t i) -> std::optional<BlockedConnection> {
            const auto& [index, states] = connections[i];
            const PathSegment& segment = path.segments[index];
            auto found = segment.kind == SegmentKind::HeadlandPass
                             ? farthestAlong(states, shapes, drivableEdges, landEdges, job)
                             : farthestOnWay(states, isDrivenFolded(path.segments, index) ? folded : shapes,
                                             segment.implementDown, drivable, land);
            if (found) {
                found->segment = index;
            }
            return found;
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
