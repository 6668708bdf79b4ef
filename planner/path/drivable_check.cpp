#include "planner/path/drivable_check.h"

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"
#include "planner/path/folded_stretches.h"
#include "planner/turns/allowed_edges.h"
#include "planner/turns/footprint_check.h"
#include "planner/turns/rig.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <numbers>
#include <optional>
#include <ranges>
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
constexpr Length kPassDrawing = metres(0.01);

Ring shrunken(Ring footprint) {
    for (Point& corner : footprint) {
        corner.x -= std::copysign(kContactM, corner.x);
        corner.y -= std::copysign(kContactM, corner.y);
    }
    return footprint;
}

std::vector<RigPart> shrunkenParts(const Machine& machine, ImplementAt implement, bool overhangs) {
    std::vector<RigPart> parts = rigParts(machine, implement, overhangs);
    for (RigPart& part : parts) {
        part.shape = shrunken(std::move(part.shape));
    }
    return parts;
}

/// The driven shapes, slightly reduced: one shape, or a tractor and its implement.
struct Shapes {
    Shapes(const Machine& machine, bool overhangs)
        : trailer{Trailer::of(machine)},
          raised{shrunkenParts(machine, ImplementAt::Raised, overhangs)},
          lowered{shrunkenParts(machine, ImplementAt::Lowered, overhangs)} {}

    const std::vector<RigPart>& parts(bool down) const { return down ? lowered : raised; }
    Pose poseOf(const RigPart& part, const RigState& state) const {
        return part.isTrailed ? trailer->poseOf(state.tractor, state.implement) : state.tractor;
    }

    std::optional<Trailer> trailer;
    std::vector<RigPart> raised;
    std::vector<RigPart> lowered;
};

/// An area, and the same without holes: a place outside that lies outside the field.
struct PreparedLand {
    explicit PreparedLand(const MultiPolygon& polygons) : area{polygons}, land{withoutHoles(polygons)} {}

    PreparedArea area;
    PreparedArea land;
};

/// The areas for connections, which are tested by outlines, and the edges for passes.
struct AreasToCheck {
    AreasToCheck(const AllowedAreas& areas, Length reach)
        : tractor{areas.tractor()},
          edges{areas, reach},
          landEdges{AllowedAreas{
                        withoutHoles(areas.tractor()),
                        areas.hasOverhang() ? std::optional{withoutHoles(areas.implement())} : std::nullopt},
                    reach} {
        if (areas.hasOverhang()) {
            implement.emplace(areas.implement());
        }
    }

    PreparedLand tractor;
    std::optional<PreparedLand> implement;  ///< where it is not the same
    AllowedEdges edges;
    AllowedEdges landEdges;
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

/// The outlines of one part along the way.
std::vector<Polyline> outlines(std::span<const RigState> states, const RigPart& part, const Shapes& shapes) {
    std::vector<Polyline> all;
    for (const RigState& state : states) {
        all.push_back(placed(part.shape, shapes.poseOf(part, state)));
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
double outsideM(const RigState& state, const Shapes& shapes, const AllowedEdges& edges) {
    double farthestM = 0.0;
    for (const RigPart& part : shapes.lowered) {
        farthestM = std::max(farthestM, outsideM(shapes.poseOf(part, state), part.shape,
                                                 part.mayOverhang ? edges.implement() : edges.tractor()));
    }
    return farthestM;
}

/// The place where a headland pass is farthest outside. Empty if it stays inside. A pass is too long for a
/// test by outlines. Ends early, with a partial result, if the job is stopped.
std::optional<BlockedConnection> farthestAlong(std::span<const RigState> states, const Shapes& shapes,
                                               const AreasToCheck& areas, const JobContext& job) {
    BlockedConnection farthest;
    RigState worst;
    for (const RigState& state : states) {
        if (job.stopRequested()) {
            break;
        }
        if (const Length outside = metres(outsideM(state, shapes, areas.edges)); outside > farthest.outside) {
            farthest.outside = outside;
            worst = state;
        }
    }
    if (farthest.outside <= kPassDrawing) {
        return std::nullopt;
    }
    farthest.place = worst.tractor.position;
    farthest.obstacle = outsideM(worst, shapes, areas.landEdges) == 0.0;
    return farthest;
}

/// The place where these parts sweep land outside of one area the farthest. Empty if they stay inside.
std::optional<BlockedConnection> farthestOnWay(std::span<const RigState> states, const Shapes& shapes,
                                               std::span<const RigPart* const> parts,
                                               const PreparedLand& prepared) {
    const PreparedArea& drivable = prepared.area;
    std::vector<Polyline> all;
    std::vector<Polyline> tracks;
    for (const RigPart* const part : parts) {
        const std::vector<Polyline> some = outlines(states, *part, shapes);
        std::ranges::move(cornerTracks(some), std::back_inserter(tracks));
        std::ranges::copy(some, std::back_inserter(all));
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
    const auto beyondLand = prepared.land.farthestOutside(lines);
    blocked.obstacle = !beyondLand;
    const auto farthest = beyondLand ? beyondLand : drivable.farthestOutside(lines);
    // A smaller excess may come from drawing, so the area counts as covered.
    if (!farthest || farthest->distance <= kPassDrawing) {
        return std::nullopt;
    }
    blocked.place = farthest->point;
    blocked.outside = farthest->distance;
    return blocked;
}

/// The place where the area swept between two stretches of work is farthest outside. Empty if it stays
/// inside.
std::optional<BlockedConnection> farthestOnWay(std::span<const RigState> states, const Shapes& shapes,
                                               bool lowered, const AreasToCheck& areas) {
    std::vector<const RigPart*> inTractors;
    std::vector<const RigPart*> inImplements;
    // The implement, which is the last part, leaves first.
    for (const RigPart& part : shapes.parts(lowered) | std::views::reverse) {
        (part.mayOverhang ? inImplements : inTractors).push_back(&part);
    }
    auto farthest = farthestOnWay(states, shapes, inTractors, areas.tractor);
    if (areas.implement) {
        auto other = farthestOnWay(states, shapes, inImplements, *areas.implement);
        if (other && (!farthest || other->outside > farthest->outside)) {
            farthest = std::move(other);
        }
    }
    return farthest;
}

/// Beyond this number of numbers all are forgotten: some megabytes.
constexpr std::size_t kMostNumbersKept = 500'000;

/// Results by what was driven, number by number.
class KnownWays {
public:
    using Key = std::vector<double>;
    using Found = std::optional<BlockedConnection>;

    /// What was found before, or what `test` finds now. That of a stopped job is not kept.
    template <class Test>
    Found get(Key key, const Test& test, const JobContext& job) {
        {
            const std::scoped_lock lock{mutex_};
            if (const auto known = known_.find(key); known != known_.end()) {
                return known->second;
            }
        }
        Found found = test();
        if (!job.stopRequested()) {
            add(std::move(key), found);
        }
        return found;
    }

private:
    void add(Key key, const Found& found) {
        const std::scoped_lock lock{mutex_};
        if (kept_ + key.size() > kMostNumbersKept) {
            known_.clear();
            kept_ = 0;
        }
        kept_ += key.size();
        known_.emplace(std::move(key), found);
    }

    std::mutex mutex_;
    std::map<Key, Found> known_;
    std::size_t kept_ = 0;
};

enum class Tested { Pass, Way, FoldedWay };

/// All that a result follows from. A mounted implement has no angle of its own.
KnownWays::Key keyOf(std::span<const RigState> states, Tested tested, bool lowered, bool hasTrailer) {
    KnownWays::Key key;
    key.reserve(2 + states.size() * (hasTrailer ? 4 : 3));
    key.push_back(static_cast<double>(tested));
    key.push_back(lowered ? 1.0 : 0.0);
    for (const RigState& state : states) {
        key.push_back(state.tractor.position.x);
        key.push_back(state.tractor.position.y);
        key.push_back(state.tractor.heading.si());
        if (hasTrailer) {
            key.push_back(state.implement.si());
        }
    }
    return key;
}

}  // namespace

struct WayChecks::Impl {
    AreasToCheck areas;
    Shapes shapes;
    Shapes folded;
    KnownWays known;
};

WayChecks::WayChecks(const AllowedAreas& drivable, const Machine& machine)
    : impl_{new Impl{
          .areas = {drivable, machine.workingFootprintWidth() + machine.spec().tractor.length},
          .shapes = {machine, drivable.hasOverhang()},
          .folded = {machine.folded(), drivable.hasOverhang()},
          .known = {},
      }} {}

WayChecks::~WayChecks() = default;

Result<std::vector<BlockedConnection>> WayChecks::blocked(const Path& path, const JobContext& job) {
    const Shapes& shapes = impl_->shapes;
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
            const Tested tested = segment.kind == SegmentKind::HeadlandPass ? Tested::Pass
                                  : isDrivenFolded(path.segments, index)    ? Tested::FoldedWay
                                                                            : Tested::Way;
            auto found = impl_->known.get(
                keyOf(states, tested, segment.implementDown, shapes.trailer.has_value()),
                [&] {
                    return tested == Tested::Pass
                               ? farthestAlong(states, shapes, impl_->areas, job)
                               : farthestOnWay(states, tested == Tested::FoldedWay ? impl_->folded : shapes,
                                               segment.implementDown, impl_->areas);
                },
                job);
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

Result<std::vector<BlockedConnection>> blockedConnections(const Path& path, const AllowedAreas& drivable,
                                                          const Machine& machine, const JobContext& job) {
    return WayChecks{drivable, machine}.blocked(path, job);
}

}  // namespace furrow
