#include "planner/headland/pass_tracks.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/polygon_memo.h"
#include "planner/geometry/simplify.h"
#include "planner/geometry/tolerances.h"
#include "planner/headland/edge_following.h"
#include "planner/headland/moving_in.h"
#include "planner/headland/rounded_region.h"
#include "planner/headland/smooth_ring.h"
#include "planner/headland/swing_out.h"
#include "planner/turns/rig.h"
#include "planner/turns/steered_line.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace furrow {

namespace {

// Factors on the radius for rounding, so that arcs drawn as chords can be driven.
constexpr std::array kRadiusReserves{1.02, 1.1, 1.25};
// An excess below this comes from drawing arcs as chords.
constexpr double kDrawingM = 4e-3;
const auto everywhere = [](Point) { return true; };
// Added to the observed move, so that the line also stays inside between the sampled places.
constexpr double kSampledReserveM = 0.01;
constexpr double kReserveFactor = 1.15;
constexpr int kMostMoves = 10;
// Step for the check when a line has to be cut.
constexpr double kCutLookM = 0.25;
// A trailed implement with a smaller angle to the tractor is in line.
constexpr double kInLineRad = 1e-3;
// Distance of sampled places, as a share of the distance between two moves, and the factor for bends.
constexpr double kLookShare = 0.2;
constexpr double kBendLooks = 4.0;
// The same if a place between them is known to be outside.
constexpr double kLookCloselyM = 0.01;
// Length of the pieces that are tested for such a place.
constexpr double kShortPieceM = 3.0;
// Largest move of the line where corners are merged. A later check finds and corrects places outside.
constexpr Length kMergeTolerance = metres(0.25);

// Beyond this number of rings all are forgotten.
constexpr std::size_t kMostRingsKept = 10'000;

enum class Look { NowAndThen, Closely };

/// The same line in short pieces. Only a piece that is outside somewhere is then sampled closely along its
/// whole length.
std::vector<CurvePiece> inShortPieces(const std::vector<CurvePiece>& pieces) {
    std::vector<CurvePiece> all;
    for (const CurvePiece& piece : pieces) {
        const auto count = std::max(1, static_cast<int>(std::ceil(piece.length.si() / kShortPieceM)));
        for (int i = 0; i < count; ++i) {
            all.push_back(
                {.length = (1.0 / count) * piece.length,
                 .curvature = piece.curvatureAt((static_cast<double>(i) / count) * piece.length),
                 .endCurvature = piece.curvatureAt((static_cast<double>(i + 1) / count) * piece.length),
                 .gear = piece.gear});
        }
    }
    return all;
}

/// The worst places along a line, at most one for each `apart`, where `looksAt` allows. A close look also
/// finds places where a corner of the field enters and leaves the footprint between two samples. Ends early
/// if the job is stopped.
std::vector<Excess> excessesAlong(const Curve& line, const Rig& rig, double apartM, Look how,
                                  const std::function<bool(Point)>& looksAt, const JobContext& job) {
    std::vector<Excess> found;
    double wayM = 0.0;
    double lastM = -apartM;
    RigState state = Rig::inLine(line.start);
    // When the line begins, a trailed implement is still coming round the last corner of the ring.
    for (const CurvePiece& piece : rig.hasTrailer() ? line.pieces : std::vector<CurvePiece>{}) {
        state = *rig.follow(state, piece, piece.length, [](const RigState&) { return true; });
    }
    state.tractor = line.start;
    const auto look = [&](const RigState& at, double hereM) {
        const double outsideM = rig.outsideM(at);
        if (outsideM <= kTrackContactM) {
            return;
        }
        const double moveM = kReserveFactor * outsideM + kSampledReserveM;
        if (hereM - lastM >= apartM || found.empty()) {
            found.push_back({at.tractor.position, moveM, outsideM});
            lastM = hereM;
        } else if (moveM > found.back().moveM) {
            found.back() = {at.tractor.position, moveM, outsideM};
        }
    };
    for (const CurvePiece& piece : how == Look::Closely ? inShortPieces(line.pieces) : line.pieces) {
        Point last = state.tractor.position;
        double goneM = 0.0;
        int looked = 0;
        // In bends the corners of the footprint move several times as far as the axle.
        const double swung =
            1.0 +
            kBendLooks * std::max(std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si())) * apartM;
        // One test of a whole straight is cheaper than samples along it.
        const bool isStraight = piece.curvature == Curvature{} && piece.endCurvature == Curvature{};
        if (how == Look::Closely || isStraight) {
            if (const auto inside = rig.driven(state, piece, metres(kTrackContactM))) {
                state = *inside;
                wayM += piece.length.si();
                continue;
            }
        }
        const bool closely = how == Look::Closely && !rig.driven(state, piece, metres(kDrawingM));
        const double stepM = closely ? kLookCloselyM : kLookShare * apartM / swung;
        const auto next = rig.follow(state, piece, metres(stepM), [&](const RigState& at) {
            goneM += distance(at.tractor.position, last);
            last = at.tractor.position;
            // In the middle of a straight nothing swings, so few samples are enough.
            const bool inLine = std::abs(wrappedAngle(at.implement - at.tractor.heading).si()) < kInLineRad;
            const bool nearEnd = std::min(goneM, piece.length.si() - goneM) <= 2.0 * apartM;
            const bool swings = closely || !isStraight || nearEnd || !inLine || looked % 5 == 0;
            if (swings && looksAt(at.tractor.position)) {
                look(at, wayM + goneM);
            }
            ++looked;
            return !job.stopRequested();
        });
        if (!next) {
            break;
        }
        state = *next;
        wayM += piece.length.si();
    }
    return found;
}

/// The ring after rounding on the driven side, so that a disc of the radius fits everywhere. Each ring is
/// treated alone: the far side of a lane narrower than a turn has its own ring.
Result<std::vector<Ring>> roundedRing(const Ring& ring, bool isHole, Length radius, const JobContext& job) {
    Polygon side{.outer = ring, .holes = {}};
    if (isHole) {
        // From outside: in a frame far enough away to have no effect.
        const Bounds box = bounds(side);
        const Point away{8.0 * radius.si(), 8.0 * radius.si()};
        const Point low = box.min - away;
        const Point high = box.max + away;
        side = {.outer = {low, {high.x, low.y}, high, {low.x, high.y}}, .holes = {ring}};
    }
    return roundedRegion(side, radius, job).transform([&](const MultiPolygon& parts) {
        std::vector<Ring> rings;
        for (const Polygon& part : parts) {
            if (!isHole) {
                rings.push_back(part.outer);
            }
            std::ranges::copy(part.holes, std::back_inserter(rings));
        }
        return rings;
    });
}

/// The lines of one ring.
struct RingLines {
    std::vector<Curve> lines;
    int givenUp = 0;
};

/// Makes lines of rings. Most corners can be rounded one by one. If they are too close for that, every part
/// that no disc of the radius can reach is removed; such rings are remembered, because most of them come
/// again when others were moved.
class RingLiner {
public:
    RingLiner(Length radius, Length gentle) : radius_{radius}, gentle_{gentle} {}

    Result<RingLines> linesOf(const Ring& ring, bool isHole, const JobContext& job) {
        RingLines made;
        if (add(ring, made)) {
            return made;
        }
        const Polygon key =
            isHole ? Polygon{.outer = {}, .holes = {ring}} : Polygon{.outer = ring, .holes = {}};
        return known_.get(key, [&](const Polygon&) { return roundedLinesOf(ring, isHole, job); });
    }

private:
    bool add(const Ring& ring, RingLines& made) const {
        auto line = smoothRing(ring, radius_, kMergeTolerance, gentle_);
        if (line) {
            made.lines.push_back(std::move(*line));
        }
        return line.has_value();
    }

    Result<RingLines> roundedLinesOf(const Ring& ring, bool isHole, const JobContext& job) const {
        RingLines made;
        // Arcs drawn as chords can be too short for their corners. Arcs of a larger radius are long enough.
        for (const double reserve : kRadiusReserves) {
            const auto rings = roundedRing(ring, isHole, reserve * radius_, job);
            if (!rings) {
                return std::unexpected(rings.error());
            }
            made = {};
            const auto failed =
                std::ranges::count_if(*rings, [&](const Ring& each) { return !add(each, made); });
            if (failed == 0 && !rings->empty()) {
                return made;
            }
            made.givenUp = std::max(1, static_cast<int>(failed));
        }
        return made;
    }

    Length radius_;
    Length gentle_;
    PolygonMemo<RingLines> known_{kMostRingsKept};
};

/// The lines of a region, ring by ring.
Result<PassTracks> linesOf(const MultiPolygon& region, Length radius, RingLiner& liner,
                           const JobContext& job) {
    PassTracks tracks;
    // A region smaller than a circle on full lock is a remainder of moving the ring.
    const Area least = squareMetres(std::numbers::pi * radius.si() * radius.si());
    const auto visit = [&](const Ring& ring, bool isHole) {
        return liner.linesOf(ring, isHole, job).transform([&](RingLines&& made) {
            std::ranges::move(made.lines, std::back_inserter(tracks.lines));
            tracks.givenUp += made.givenUp;
        });
    };
    for (const Polygon& polygon : region) {
        if (area(polygon) < least) {
            continue;
        }
        Result<void> visited = visit(polygon.outer, false);
        for (std::size_t i = 0; visited && i < polygon.holes.size(); ++i) {
            visited = visit(polygon.holes[i], true);
        }
        if (!visited) {
            return std::unexpected(visited.error());
        }
    }
    return tracks;
}

/// A region whose lines follow the edges, or the given region if that fails.
Result<MultiPolygon> alongEdges(const MultiPolygon& region, const AllowedAreas& drivable,
                                const Machine& machine, const FollowingRules& following, RingLiner& liner,
                                const JobContext& job) {
    const auto straight = linesOf(region, machine.minTurningRadius(), liner, job);
    if (!straight) {
        return std::unexpected(straight.error());
    }
    if (straight->givenUp > 0) {
        return region;
    }
    const AllowedEdges edges{drivable, machine.workingFootprintWidth() + machine.spec().tractor.length};
    MultiPolygon outer;
    MultiPolygon holes;
    for (const Curve& line : straight->lines) {
        Ring ring = simplifiedRing(followingTheEdge(line, edges, machine, following), kRingTolerance);
        const bool isOuter = signedAreaM2(ring) > 0.0;
        if (!isOuter) {
            std::ranges::reverse(ring);
        }
        (isOuter ? outer : holes).push_back({.outer = std::move(ring), .holes = {}});
    }
    // A line that crosses itself or its neighbour is made valid before it is subtracted.
    MultiPolygon taken;
    for (const Polygon& hole : holes) {
        auto valid = madeValid({hole}, job);
        if (!valid) {
            return std::unexpected(valid.error());
        }
        std::ranges::move(*valid, std::back_inserter(taken));
    }
    auto followed = madeValid(outer, job).and_then([&](const MultiPolygon& valid) {
        return unionOf(taken, job).and_then([&](const MultiPolygon& one) {
            return difference(valid, one, job);
        });
    });
    const auto along = followed.and_then(
        [&](const MultiPolygon& valid) { return linesOf(valid, machine.minTurningRadius(), liner, job); });
    if (!along) {
        return std::unexpected(along.error());
    }
    // In places that are too narrow, the line along the edges crosses itself.
    const bool isWhole = along->givenUp == 0 && along->lines.size() == straight->lines.size();
    return isWhole ? std::move(followed) : region;
}

/// The distance that tail or nose reach from the axle. It is the scale on which a swing-out is prepared.
double overhangM(const Machine& machine) {
    double farthest = 0.0;
    for (const Point& corner : Trailer::of(machine) ? tractorOutline(machine) : machine.workingFootprint()) {
        farthest = std::max(farthest, std::abs(corner.x));
    }
    return farthest;
}

}  // namespace

Result<PassTracks> passTracks(const MultiPolygon& workable, Length inset, const AllowedAreas& drivable,
                              const Machine& machine, const TrackRules& rules, const JobContext& job) {
    const Length radius = machine.minTurningRadius();
    const double reachM = overhangM(machine);
    RingLiner liner{radius, metres(reachM)};
    auto base = eroded(workable, inset, kRoundTolerance, job);
    // Leaving a pass along the edge swings the tail out like a corner does. If no corner makes room for that,
    // one place gets it.
    const double besideM = radius.si() + 0.5 * machine.workingFootprintWidth().si();
    const double swingM = std::hypot(besideM, reachM) - besideM;
    const bool touches =
        !Trailer::of(machine) && inset.si() < 0.5 * machine.workingFootprintWidth().si() + swingM;
    const Rig rig{drivable, machine, ImplementAt::Lowered};
    const FollowingRules following{.beside = rules.beside,
                                   .leftOut = PointGrid{{rules.driven.begin(), rules.driven.end()}},
                                   .aroundM = besideM + reachM};
    if (rules.followsEdges && rules.movesIn && !rig.hasTrailer()) {
        base = base.and_then([&](const MultiPolygon& region) {
            return alongEdges(region, drivable, machine, following, liner, job);
        });
    }
    Displacement displacement{reachM};
    const auto lines = [&] {
        return base.and_then([&](const MultiPolygon& region) { return moved(region, displacement, job); })
            .and_then([&](const MultiPolygon& region) { return linesOf(region, radius, liner, job); });
    };
    Result<PassTracks> tracks = lines();
    for (int round = 0; tracks && rules.movesIn; ++round) {
        if (rig.hasTrailer()) {
            std::ranges::transform(tracks->lines, tracks->lines.begin(),
                                   [&rig](const Curve& line) { return swungOut(line, rig); });
        }
        // Beside a corner, where a ring begins before it is eased.
        std::vector<Point> begins;
        std::ranges::transform(tracks->lines, std::back_inserter(begins),
                               [](const Curve& line) { return line.start.position; });
        if (rules.isSteered) {
            std::ranges::transform(tracks->lines, tracks->lines.begin(), [&](const Curve& line) {
                return steeredRing(line, machine, [&](Point place) { return following.leavesOut(place); });
            });
        }
        const auto look = [&](Look how, const std::function<bool(Point)>& looksAt) {
            std::vector<Excess> excesses;
            for (std::size_t i = 0; i < tracks->lines.size(); ++i) {
                const Curve& line = tracks->lines[i];
                std::vector<Excess> found = excessesAlong(line, rig, 0.5 * reachM, how, looksAt, job);
                std::erase_if(found, [&](const Excess& excess) { return following.leavesOut(excess.place); });
                std::ranges::copy(found, std::back_inserter(excesses));
                const bool canBeLeft =
                    std::ranges::any_of(found, [&](const Excess& excess) { return excess.moveM >= swingM; });
                if (round == 0 && touches && !canBeLeft && rules.driven.empty()) {
                    excesses.push_back({begins[i], kReserveFactor * swingM + kSampledReserveM, 0.0});
                }
            }
            return excesses;
        };
        std::vector<Excess> excesses =
            look(Look::NowAndThen, [&](Point place) { return displacement.changedLastAt(place); });
        // Merged corners may move the line a little farther away.
        if (excesses.empty()) {
            excesses = look(Look::Closely, everywhere);
        }
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (excesses.empty() || round == kMostMoves) {
            tracks->inside = excesses.empty() && rules.driven.empty();
            break;
        }
        displacement.add(std::move(excesses));
        tracks = lines();
    }
    if (!tracks) {
        return tracks;
    }
    for (const Polygon& polygon : *base) {
        for (const Point& point : polygon.outer) {
            tracks->movedIn = std::max(tracks->movedIn, metres(displacement.at(point)));
        }
    }
    return tracks;
}

std::vector<Point> placesOutside(const Curve& line, const AllowedAreas& drivable, const Machine& machine,
                                 const JobContext& job) {
    std::vector<Point> places;
    const Rig rig{drivable, machine, ImplementAt::Lowered};
    for (const Excess& excess :
         excessesAlong(line, rig, 0.5 * overhangM(machine), Look::Closely, everywhere, job)) {
        if (excess.outsideM > kDrawingM) {
            places.push_back(excess.place);
        }
    }
    return places;
}

std::vector<Curve> partsInside(const Curve& closedLine, const AllowedAreas& drivable, const Machine& machine,
                               const JobContext& job) {
    // The line also stays away before and after such a place, by this distance.
    const double awayM = 2.0 * kCutLookM;
    const Rig rig{drivable, machine, ImplementAt::Lowered};
    std::vector<std::pair<double, double>> parts;
    double gone = 0.0;
    double begins = 0.0;
    RigState state = Rig::inLine(closedLine.start);
    for (const CurvePiece& piece : closedLine.pieces) {
        if (job.stopRequested()) {
            return {closedLine};
        }
        if (const auto next = rig.driven(state, piece, metres(kDrawingM))) {
            state = *next;
            gone += piece.length.si();
            continue;
        }
        // Some place in this piece is outside: find it step by step.
        const auto steps = std::max(1, static_cast<int>(std::ceil(piece.length.si() / kCutLookM)));
        CurvePiece step = piece;
        step.length = (1.0 / steps) * piece.length;
        for (int i = 0; i < steps; ++i) {
            const bool isInside = rig.driven(state, step, metres(kDrawingM)).has_value();
            state = *rig.follow(state, step, step.length, [](const RigState&) { return true; });
            gone += step.length.si();
            if (!isInside) {
                if (gone - step.length.si() - awayM > begins) {
                    parts.emplace_back(begins, gone - step.length.si() - awayM);
                }
                begins = gone + awayM;
            }
        }
    }
    if (begins == 0.0) {
        return {closedLine};
    }
    if (begins < gone) {
        parts.emplace_back(begins, gone);
    }
    std::vector<Curve> kept;
    std::ranges::transform(parts, std::back_inserter(kept), [&](const auto& part) {
        return partOf(closedLine, metres(part.first), metres(part.second));
    });
    // The start of the closed line is no cut: join the last and the first part.
    if (kept.size() > 1 && parts.front().first == 0.0 && parts.back().second == gone) {
        std::ranges::copy(kept.front().pieces, std::back_inserter(kept.back().pieces));
        kept.erase(kept.begin());
    }
    std::erase_if(kept, [&](const Curve& part) { return part.length() < machine.operatingWidth(); });
    return kept;
}

}  // namespace furrow
