#include "planner/headland/pass_tracks.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/simplify.h"
#include "planner/headland/edge_following.h"
#include "planner/headland/smooth_ring.h"
#include "planner/headland/swing_out.h"
#include "planner/turns/curve_parts.h"
#include "planner/turns/rig.h"

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

// Rounded by a little more than the radius, so that arcs drawn as chords can be driven.
constexpr std::array kRadiusReserves{1.02, 1.1, 1.25};
// Outside by less than this is touching.
constexpr double kTouchingM = 8e-4;
// And by less than this it is drawing.
constexpr double kDrawingM = 4e-3;
const auto everywhere = [](Point) { return true; };
// Moved in by a little more than was seen, so that it stays inside between the places that were looked at.
constexpr double kReserveM = 0.01;
constexpr double kReserveFactor = 1.15;
// Where it moves by less it does not move: the bend that begins there swings nothing out.
constexpr double kLeastMoveM = 2e-4;
constexpr int kMostMoves = 10;
// Where that is not enough the line is cut; looked at so often.
constexpr double kCutLookM = 0.25;
// A trailed implement that points elsewhere than the tractor by less is in line.
constexpr double kInLineRad = 1e-3;
// Places that are looked at lie so many of the distances between two moves apart.
constexpr double kLookShare = 0.2;
constexpr double kBendLooks = 4.0;
// And so far where something is known to be outside between them.
constexpr double kLookCloselyM = 0.01;
// In pieces so long it is asked whether something is.
constexpr double kShortPieceM = 3.0;
// Points of a ring that can be moved lie no farther apart.
constexpr double kDenseM = 1.0;
// Points of a moved ring that make less difference are left out.
constexpr Length kSimplified = metres(5e-4);
// How far the line may move where corners are merged to be driven; what that takes outside is found and mended.
constexpr Length kMergeTolerance = metres(0.25);
// How fine an arc around an inward corner is drawn.
constexpr Length kRoundTolerance = metres(0.01);

/// What is left when no disc of the radius may stick out: outward corners rounded, necks cut.
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

/// How a ring turns at one of its points, to the left, and which way leads inside from there.
struct Bend {
    double turnRad = 0.0;
    Point inward;
};

Bend bendAt(const Ring& ring, std::size_t i) {
    const Point in = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
    const Point out = ring[(i + 1) % ring.size()] - ring[i];
    const double turn = std::atan2(cross(in, out), dot(in, out));
    return {turn, direction(std::atan2(in.y, in.x) + 0.5 * turn + 0.5 * std::numbers::pi)};
}

/// Around a corner that points into the region a disc of the radius that touches it there: what is left can be
/// driven around it.
MultiPolygon discsAtInwardCorners(const Polygon& region, double radiusM) {
    MultiPolygon discs;
    const auto visit = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Bend bend = bendAt(ring, i);
            // The disc sticks out of the edges by this; less is not worth one.
            if (bend.turnRad < 0.0 && radiusM * (1.0 - std::cos(0.5 * bend.turnRad)) > kRoundTolerance.si()) {
                discs.push_back(disc(ring[i] - radiusM * bend.inward, radiusM));
            }
        }
    };
    visit(region.outer);
    std::ranges::for_each(region.holes, visit);
    return discs;
}

/// What a vehicle can drive along: inward corners cut back to the radius, outward ones rounded, necks cut.
Result<MultiPolygon> rounded(const Polygon& region, Length radius, const JobContext& job) {
    const MultiPolygon discs = discsAtInwardCorners(region, radius.si());
    Result<MultiPolygon> left = MultiPolygon{region};
    if (!discs.empty()) {
        left = unionOf(discs, job).and_then([&](const MultiPolygon& taken) { return difference({region}, taken, job); });
    }
    return left.and_then([&](const MultiPolygon& polygons) { return opened(polygons, radius, job); });
}

/// A place where the footprint is outside, and how far the pass has to move in there.
struct Excess {
    Point place;
    double moveM = 0.0;
    double outsideM = 0.0;
};

/// How far the pass has to move in at each place: as far as was seen there, less with the distance from it.
class Displacement {
public:
    explicit Displacement(double reachM) : reachM_{reachM} {}

    /// What one round of looking has found adds to the rounds before.
    void add(std::vector<Excess> excesses) {
        std::ranges::sort(excesses, {}, [](const Excess& excess) { return excess.place.x; });
        rounds_.push_back(std::move(excesses));
    }
    bool isEmpty() const { return rounds_.empty(); }
    /// Whether the last round has moved anything here.
    bool changedLastAt(Point point) const { return rounds_.empty() || mostAt(point, rounds_.back()) > 0.0; }

    double at(Point point) const {
        double sum = 0.0;
        for (const std::vector<Excess>& round : rounds_) {
            sum += mostAt(point, round);
        }
        return sum < kLeastMoveM ? 0.0 : sum;
    }

private:
    /// The sum within one round would grow with the number of places: the one that asks for most counts.
    double mostAt(Point point, const std::vector<Excess>& round) const {
        // Farther away exp() leaves less than is worth a move.
        const double seenM = 10.0 * reachM_;
        const auto xOf = [](const Excess& excess) { return excess.place.x; };
        double most = 0.0;
        for (auto it = std::ranges::lower_bound(round, point.x - seenM, {}, xOf);
             it != round.end() && it->place.x <= point.x + seenM; ++it) {
            if (std::abs(it->place.y - point.y) <= seenM) {
                const double away = distance(point, it->place);
                most = std::max(most, it->moveM * std::exp(-std::max(0.0, away - reachM_) / reachM_));
            }
        }
        return most;
    }

    double reachM_;
    std::vector<std::vector<Excess>> rounds_;
};

/// Points close enough for the curve that the ring moves on to, and none where it does not move.
Ring densified(const Ring& ring, const Displacement& displacement) {
    Ring dense;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point from = ring[i];
        const Point way = ring[(i + 1) % ring.size()] - from;
        const auto pieces = std::max(1, static_cast<int>(std::ceil(norm(way) / kDenseM)));
        bool wasMoved = true;
        for (int k = 0; k < pieces; ++k) {
            const Point at = from + (static_cast<double>(k) / pieces) * way;
            const bool isMoved = displacement.at(at) > 0.0;
            if (k == 0 || isMoved || wasMoved) {
                dense.push_back(at);
            }
            wasMoved = isMoved;
        }
    }
    return dense;
}

Ring moved(const Ring& ring, const Displacement& displacement) {
    const Ring dense = densified(ring, displacement);
    Ring result;
    for (std::size_t i = 0; i < dense.size(); ++i) {
        const Bend bend = bendAt(dense, i);
        // At a corner the point moves along the bisector so that both edges move by the same.
        const double mitre = 1.0 / std::max(0.5, std::cos(0.5 * bend.turnRad));
        result.push_back(dense[i] + displacement.at(dense[i]) * mitre * bend.inward);
    }
    // Fewer points on the same curve: the buffers cost by the point.
    return simplifiedRing(std::move(result), kSimplified);
}

Result<MultiPolygon> moved(const MultiPolygon& polygons, const Displacement& displacement, const JobContext& job) {
    if (displacement.isEmpty()) {
        return polygons;
    }
    MultiPolygon result;
    for (const Polygon& polygon : polygons) {
        result.push_back({.outer = moved(polygon.outer, displacement), .holes = {}});
        for (const Ring& hole : polygon.holes) {
            result.back().holes.push_back(moved(hole, displacement));
        }
    }
    return madeValid(result, job);
}

enum class Look { NowAndThen, Closely };

/// The same line in pieces of which one that gets outside somewhere is soon looked at all along.
std::vector<TurnPiece> inShortPieces(const std::vector<TurnPiece>& pieces) {
    std::vector<TurnPiece> all;
    for (const TurnPiece& piece : pieces) {
        const auto count = std::max(1, static_cast<int>(std::ceil(piece.length.si() / kShortPieceM)));
        for (int i = 0; i < count; ++i) {
            all.push_back({.length = (1.0 / count) * piece.length,
                           .curvature = piece.curvatureAt((static_cast<double>(i) / count) * piece.length),
                           .endCurvature = piece.curvatureAt((static_cast<double>(i + 1) / count) * piece.length),
                           .gear = piece.gear});
        }
    }
    return all;
}

/// The worst places along a line, at most one for each `apart`, where `looksAt` says so. Looked at closely, also those
/// where a corner of the field goes in and out of the footprint between two looks. Ends early where the job is stopped.
std::vector<Excess> excessesAlong(const Turn& line, const Rig& rig, double apartM, Look how,
                                  const std::function<bool(Point)>& looksAt, const JobContext& job) {
    std::vector<Excess> found;
    double wayM = 0.0;
    double lastM = -apartM;
    RigState state = Rig::inLine(line.start);
    // An implement that trails comes round the last corner of the ring when the line begins.
    for (const TurnPiece& piece : rig.hasTrailer() ? line.pieces : std::vector<TurnPiece>{}) {
        state = *rig.follow(state, piece, piece.length, [](const RigState&) { return true; });
    }
    state.tractor = line.start;
    const auto look = [&](const RigState& at, double hereM) {
        const double outsideM = rig.outsideM(at);
        if (outsideM <= kTouchingM) {
            return;
        }
        const double moveM = kReserveFactor * outsideM + kReserveM;
        if (hereM - lastM >= apartM || found.empty()) {
            found.push_back({at.tractor.position, moveM, outsideM});
            lastM = hereM;
        } else if (moveM > found.back().moveM) {
            found.back() = {at.tractor.position, moveM, outsideM};
        }
    };
    for (const TurnPiece& piece : how == Look::Closely ? inShortPieces(line.pieces) : line.pieces) {
        Point last = state.tractor.position;
        double goneM = 0.0;
        int looked = 0;
        // In bends the corners of the footprint go several times as far as the axle.
        const double swung = 1.0 + kBendLooks * std::abs(piece.curvature.si()) * apartM;
        // Straights are cleared as a whole for less than it takes to look now and then.
        const bool isStraight = piece.curvature == Curvature{} && piece.endCurvature == Curvature{};
        if (how == Look::Closely || isStraight) {
            if (const auto inside = rig.driven(state, piece, metres(kTouchingM))) {
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
            // In the middle of a straight nothing swings: now and then is often enough.
            const bool inLine = std::abs((at.implement - at.tractor.heading).si()) < kInLineRad;
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

/// What a ring becomes when no disc of the radius may stick out of the side that is driven: seen by itself, since what
/// lies on the far side of a lane that is narrower than a turn has a ring of its own.
Result<std::vector<Ring>> roundedRing(const Ring& ring, bool isHole, Length radius, const JobContext& job) {
    Polygon side{.outer = ring, .holes = {}};
    if (isHole) {
        // From outside: in a frame so far away that it does not matter.
        const Bounds box = bounds({side});
        const Point away{8.0 * radius.si(), 8.0 * radius.si()};
        const Point low = box.min - away;
        const Point high = box.max + away;
        side = {.outer = {low, {high.x, low.y}, high, {low.x, high.y}}, .holes = {ring}};
    }
    return rounded(side, radius, job).transform([&](const MultiPolygon& parts) {
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

/// The lines of a region, ring by ring. Most corners can be rounded one by one; where they are too close for that,
/// everything goes that no disc of the radius can reach.
Result<PassTracks> linesOf(const MultiPolygon& region, Length radius, Length gentle, const JobContext& job) {
    PassTracks tracks;
    // Less than a turn on full lock holds is a crumb of moving the ring.
    const Area least = squareMetres(std::numbers::pi * radius.si() * radius.si());
    const auto add = [&](const Ring& ring) {
        auto line = smoothRing(ring, radius, kMergeTolerance, gentle);
        if (line) {
            tracks.lines.push_back(std::move(*line));
        }
        return line.has_value();
    };
    const auto visit = [&](const Ring& ring, bool isHole) -> Result<void> {
        if (add(ring)) {
            return {};
        }
        // Arcs drawn as chords are too short for their corners now and then: those of a larger radius are not.
        for (const double reserve : kRadiusReserves) {
            const auto rings = roundedRing(ring, isHole, reserve * radius, job);
            if (!rings) {
                return std::unexpected(rings.error());
            }
            const std::size_t before = tracks.lines.size();
            const auto failed = std::ranges::count_if(*rings, [&](const Ring& each) { return !add(each); });
            if (failed == 0 && !rings->empty()) {
                return {};
            }
            if (reserve != kRadiusReserves.back()) {
                tracks.lines.resize(before);
            } else {
                tracks.givenUp += std::max(1, static_cast<int>(failed));
            }
        }
        return {};
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

/// A region whose lines follow the edges; the region itself where that cannot be.
Result<MultiPolygon> alongEdges(const MultiPolygon& region, const MultiPolygon& drivable, const Machine& machine,
                                const FollowingRules& following, Length gentle, const JobContext& job) {
    const auto straight = linesOf(region, machine.minTurningRadius(), gentle, job);
    if (!straight) {
        return std::unexpected(straight.error());
    }
    if (straight->givenUp > 0) {
        return region;
    }
    const BoundaryDistance edges{drivable, machine.workingFootprintWidth() + machine.spec().tractor.length};
    MultiPolygon outer;
    MultiPolygon holes;
    for (const Turn& line : straight->lines) {
        Ring ring = simplifiedRing(followingTheEdge(line, edges, machine, following), kSimplified);
        const bool isOuter = signedAreaM2(ring) > 0.0;
        if (!isOuter) {
            std::ranges::reverse(ring);
        }
        (isOuter ? outer : holes).push_back({.outer = std::move(ring), .holes = {}});
    }
    // A line that crosses itself or its neighbour somewhere is no shape to take away yet.
    MultiPolygon taken;
    for (const Polygon& hole : holes) {
        auto valid = madeValid({hole}, job);
        if (!valid) {
            return std::unexpected(valid.error());
        }
        std::ranges::move(*valid, std::back_inserter(taken));
    }
    auto followed = madeValid(outer, job).and_then([&](const MultiPolygon& valid) {
        return unionOf(taken, job).and_then([&](const MultiPolygon& one) { return difference(valid, one, job); });
    });
    const auto along = followed.and_then([&](const MultiPolygon& valid) {
        return linesOf(valid, machine.minTurningRadius(), gentle, job);
    });
    if (!along) {
        return std::unexpected(along.error());
    }
    // In a place too narrow for it the line that follows the edges crosses itself.
    const bool isWhole = along->givenUp == 0 && along->lines.size() == straight->lines.size();
    return isWhole ? std::move(*followed) : region;
}

/// How far tail or nose reach from the axle: the scale on which a swing-out has to be prepared.
double overhangM(const Machine& machine) {
    double farthest = 0.0;
    for (const Point& corner : Trailer::of(machine) ? tractorOutline(machine) : machine.workingFootprint()) {
        farthest = std::max(farthest, std::abs(corner.x));
    }
    return farthest;
}

}  // namespace

Result<PassTracks> passTracks(const MultiPolygon& workable, Length inset, const MultiPolygon& drivable,
                              const Machine& machine, const TrackRules& rules, const JobContext& job) {
    const Length radius = machine.minTurningRadius();
    const double reachM = overhangM(machine);
    auto base = eroded(workable, inset, kRoundTolerance, job);
    // Leaving a pass that runs along the edge swings the tail out as a corner does: where no corner makes room for
    // that, one place gets it.
    const double besideM = radius.si() + 0.5 * machine.workingFootprintWidth().si();
    const double swingM = std::hypot(besideM, reachM) - besideM;
    const bool touches = !Trailer::of(machine) && inset.si() < 0.5 * machine.workingFootprintWidth().si() + swingM;
    const Rig rig{drivable, machine, ImplementAt::Lowered};
    const FollowingRules following{.beside = rules.beside, .leftOut = rules.driven, .aroundM = besideM + reachM};
    if (rules.followsEdges && rules.movesIn && !rig.hasTrailer()) {
        base = base.and_then([&](const MultiPolygon& region) {
            return alongEdges(region, drivable, machine, following, metres(reachM), job);
        });
    }
    Displacement displacement{reachM};
    const auto lines = [&] {
        return base.and_then([&](const MultiPolygon& region) { return moved(region, displacement, job); })
            .and_then([&](const MultiPolygon& region) { return linesOf(region, radius, metres(reachM), job); });
    };
    Result<PassTracks> tracks = lines();
    for (int round = 0; tracks && rules.movesIn; ++round) {
        if (rig.hasTrailer()) {
            std::ranges::transform(tracks->lines, tracks->lines.begin(),
                                   [&rig](const Turn& line) { return swungOut(line, rig); });
        }
        const auto look = [&](Look how, const std::function<bool(Point)>& looksAt) {
            std::vector<Excess> excesses;
            for (const Turn& line : tracks->lines) {
                std::vector<Excess> found = excessesAlong(line, rig, 0.5 * reachM, how, looksAt, job);
                std::erase_if(found, [&](const Excess& excess) { return following.leavesOut(excess.place); });
                std::ranges::copy(found, std::back_inserter(excesses));
                const bool canBeLeft =
                    std::ranges::any_of(found, [&](const Excess& excess) { return excess.moveM >= swingM; });
                if (round == 0 && touches && !canBeLeft && rules.driven.empty()) {
                    excesses.push_back({line.start.position, kReserveFactor * swingM + kReserveM, 0.0});
                }
            }
            return excesses;
        };
        std::vector<Excess> excesses = look(Look::NowAndThen, [&](Point place) { return displacement.changedLastAt(place); });
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

std::vector<Point> placesOutside(const Turn& line, const MultiPolygon& drivable, const Machine& machine,
                                 const JobContext& job) {
    std::vector<Point> places;
    const Rig rig{drivable, machine, ImplementAt::Lowered};
    for (const Excess& excess : excessesAlong(line, rig, 0.5 * overhangM(machine), Look::Closely, everywhere, job)) {
        if (excess.outsideM > kDrawingM) {
            places.push_back(excess.place);
        }
    }
    return places;
}

std::vector<Turn> partsInside(const Turn& closedLine, const MultiPolygon& drivable, const Machine& machine,
                              const JobContext& job) {
    // So far before and after such a place the line stays away from it, too.
    const double awayM = 2.0 * kCutLookM;
    const Rig rig{drivable, machine, ImplementAt::Lowered};
    std::vector<std::pair<double, double>> parts;
    double gone = 0.0;
    double begins = 0.0;
    RigState state = Rig::inLine(closedLine.start);
    for (const TurnPiece& piece : closedLine.pieces) {
        if (job.stopRequested()) {
            return {closedLine};
        }
        if (const auto next = rig.driven(state, piece, metres(kDrawingM))) {
            state = *next;
            gone += piece.length.si();
            continue;
        }
        // Somewhere in it: looked for step by step.
        const auto steps = std::max(1, static_cast<int>(std::ceil(piece.length.si() / kCutLookM)));
        TurnPiece step = piece;
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
    std::vector<Turn> kept;
    std::ranges::transform(parts, std::back_inserter(kept), [&](const auto& part) {
        return partOf(closedLine, metres(part.first), metres(part.second));
    });
    // It begins and ends somewhere on the way: that is no cut.
    if (kept.size() > 1 && parts.front().first == 0.0 && parts.back().second == gone) {
        std::ranges::copy(kept.front().pieces, std::back_inserter(kept.back().pieces));
        kept.erase(kept.begin());
    }
    std::erase_if(kept, [&](const Turn& part) { return part.length() < machine.operatingWidth(); });
    return kept;
}

}  // namespace furrow
