#include "planner/turns/rig.h"

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/tolerances.h"
#include "planner/turns/footprint_check.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

// Shortest distances between samples of a machine that is flush with an edge. In bends beside a corner of the
// field the samples are close enough that it cannot pass through a corner of the footprint unseen.
constexpr double kLookOnStraightM = 0.2;
constexpr double kLookInBendM = 0.05;
constexpr double kLookAtCornersM = 0.01;
// A trailed implement with a smaller angle to its tractor goes straight on with it.
constexpr double kInLineRad = 1e-9;
// Between two places at which the room for a turn on the spot is looked at. The ends of the machine bulge out
// of the chord by its reach * step² / 8, less than a tenth of a millimetre.
constexpr double kSpotStepRad = 0.01;
// Shorter straights are sampled place by place.
constexpr double kShortM = 0.1;

}  // namespace

std::vector<Rig::Part> Rig::partsOf(const Machine& machine, ImplementAt implement, bool overhangs) {
    std::vector<Part> parts;
    for (RigPart& part : rigParts(machine, implement, overhangs)) {
        const double radiusM = radiusOf(part.shape);
        const Bounds box = bounds(part.shape);
        parts.push_back({std::move(part.shape), radiusM, box, part.isTrailed, part.mayOverhang});
    }
    return parts;
}

double Rig::radiusM(bool isTrailed) const {
    double radiusM = 0.0;
    for (const Part& part : parts_) {
        radiusM = part.isTrailed == isTrailed ? std::max(radiusM, part.radiusM) : radiusM;
    }
    return radiusM;
}

Rig::Rig(const AllowedAreas& areas, const Machine& machine, ImplementAt implement)
    : machine_{machine},
      steered_{machine.withSteeringReserve()},
      trailer_{Trailer::of(machine)},
      parts_{partsOf(machine, implement, areas.hasOverhang())},
      tractorRadiusM_{radiusM(false)},
      trailedRadiusM_{radiusM(true)},
      edges_{areas, metres(1.0 + std::max(tractorRadiusM_, trailedRadiusM_))} {}

FootprintRoom Rig::roomAround(const Part& part, const Pose& pose, double noLessM) const {
    const BoundaryDistance& edges = edgesFor(part);
    const double inside = edges.insideM(pose.position).value_or(edges.reachM());
    if (inside > part.radiusM) {
        return {inside - part.radiusM, inside - part.radiusM};
    }
    return furrow::roomAround(pose, part.shape, part.radiusM, edges, noLessM);
}

FootprintRoom Rig::roomAt(const RigState& state, double noLessM) const {
    FootprintRoom least = roomAround(parts_.front(), poseOf(parts_.front(), state), noLessM);
    for (const Part& part : parts_ | std::views::drop(1)) {
        if (least.least() < noLessM) {
            break;
        }
        const FootprintRoom room = roomAround(part, poseOf(part, state), noLessM);
        least = {std::min(least.edgesM, room.edgesM), std::min(least.cornersM, room.cornersM)};
    }
    return least;
}

double Rig::crossedM(const Part& part, const Pose& pose) const {
    const BoundaryDistance& edges = edgesFor(part);
    if (edges.insideM(pose.position).value_or(edges.reachM()) > part.radiusM) {
        return 0.0;
    }
    return edges.crossedM(pose.position, placed(part.shape, pose));
}

double Rig::crossedM(const RigState& state) const {
    double deepest = 0.0;
    for (const Part& part : parts_) {
        deepest = std::max(deepest, crossedM(part, poseOf(part, state)));
    }
    return deepest;
}

double Rig::roomM(const RigState& state) const {
    const double room = roomAt(state).least();
    if (room < 0.0) {
        return room;
    }
    // Long, thin shapes can cross the sides without a corner of either inside the other.
    const double crossed = crossedM(state);
    return crossed > 0.0 ? -crossed : room;
}

RigState Rig::stateAfter(const RigState& from, const RigState& last, const CurvePiece& piece,
                         Length way) const {
    const Pose pose = advanced(from.tractor, piece, way);
    if (!trailer_) {
        return inLine(pose);
    }
    if (stepsFor(piece)) {
        return {pose, trailer_->headingAfter(last.implement, last.tractor, pose)};
    }
    const Length signedWay = piece.gear == Gear::Forward ? way : -way;
    return {pose, trailer_->headingAfter(from.implement, from.tractor.heading, piece.curvature, signedWay)};
}

std::optional<RigState> Rig::follow(const RigState& from, const CurvePiece& piece, Length step,
                                    const std::function<bool(const RigState&)>& visit) const {
    const Length longest = std::min(step, stepsFor(piece).value_or(step));
    const auto steps = std::max(1, static_cast<int>(std::ceil(piece.length / longest)));
    const auto visited = std::max(1, static_cast<int>(step / longest));
    RigState at = from;
    for (int i = 1; i <= steps; ++i) {
        at = stateAfter(from, at, piece, piece.length * (static_cast<double>(i) / steps));
        if ((i % visited == 0 || i == steps) && !visit(at)) {
            return std::nullopt;
        }
    }
    return at;
}

bool Rig::isClearAhead(const Part& part, const Pose& pose, double wayM, double touchingM) const {
    Bounds swept = part.box;
    swept.min.x = std::min(swept.min.x, 0.0) + std::min(wayM, 0.0);
    swept.max.x = std::max(swept.max.x, 0.0) + std::max(wayM, 0.0);
    // A shape that begins inside and crosses no edge stays inside.
    const BoundaryDistance& edges = edgesFor(part);
    return swept.height() < 2.0 * edges.reachM() && edges.insideM(pose.position).value_or(0.0) >= 0.0 &&
           !edges.reachInto(pose.position, direction(pose.heading.si()), swept, touchingM);
}

bool Rig::isClearAhead(const RigState& state, double wayM, double touchingM) const {
    const bool isInLine =
        !trailer_ || std::abs(wrappedAngle(state.implement - state.tractor.heading).si()) < kInLineRad;
    return isInLine && std::ranges::all_of(parts_, [&](const Part& part) {
               return isClearAhead(part, poseOf(part, state), wayM, touchingM);
           });
}

std::optional<RigState> Rig::driven(const RigState& from, const CurvePiece& piece, Length touching,
                                    FootprintRoom known) const {
    return drivenOn(from, piece, touching, known);
}

std::optional<RigState> Rig::drivenOn(const RigState& from, const CurvePiece& piece, Length touching,
                                      FootprintRoom& room) const {
    if (piece.onTheSpot != Angle{}) {
        if (!mayTurnOnTheSpot(from.tractor, piece.onTheSpot)) {
            return std::nullopt;
        }
        room = {};
        return inLine(advanced(from.tractor, piece, piece.length));
    }
    // No point moves by more than this for each metre of the way.
    const double bent = std::max(std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si()));
    const double swings =
        std::max(1.0 + bent * tractorRadiusM_, trailer_ ? 1.0 + trailedRadiusM_ / trailer_->trailingM : 0.0);
    const bool isStraight = bent == 0.0;
    const auto freeWay = [&] {
        const double alongEdges =
            std::max(room.edgesM / swings, isStraight ? kLookOnStraightM : kLookInBendM);
        const double atCorners =
            std::max(room.cornersM / swings, isStraight ? kLookInBendM : kLookAtCornersM);
        return std::min(alongEdges, atCorners);
    };
    RigState at = from;
    const double lengthM = piece.length.si();
    double free = room.least() / swings;  // of the way ahead
    const double wayM = piece.gear == Gear::Forward ? lengthM : -lengthM;
    if (isStraight && lengthM > std::max(kShortM, free) && isClearAhead(from, wayM, touching.si())) {
        room = {};
        return RigState{advanced(from.tractor, piece, piece.length), from.implement};
    }
    const auto roomIfInside = [&](const RigState& state) -> std::optional<FootprintRoom> {
        const FootprintRoom here = roomAt(state, -touching.si());
        // If its own corners lie along an edge and a corner of the field along its side, an edge may come
        // in between.
        const bool isOutside = here.least() < -touching.si() ||
                               (here.least() < kLookAtCornersM && crossedM(state) > touching.si());
        return isOutside ? std::nullopt : std::optional{here};
    };
    const std::optional<Length> longest = stepsFor(piece);
    // Most ways that lead outside are outside at their end, too.
    std::optional<FootprintRoom> atEnd;
    if (!longest && free < lengthM) {
        atEnd = roomIfInside(stateAfter(from, from, piece, piece.length));
        if (!atEnd) {
            return std::nullopt;
        }
    }
    double lookedM = 0.0;
    double surelyToM = free;
    for (double goneM = 0.0; goneM < lengthM;) {
        double stepM = std::min(std::max(free, kLookAtCornersM), lengthM - goneM);
        if (longest) {
            stepM = std::min(stepM, longest->si());
        }
        goneM = lengthM - goneM - stepM < kRoundingM ? lengthM : goneM + stepM;
        at = stateAfter(from, at, piece, metres(goneM));
        free -= stepM;
        if (free <= kRoundingM || (goneM == lengthM && goneM > surelyToM)) {
            const auto here = atEnd && goneM == lengthM ? atEnd : roomIfInside(at);
            if (!here) {
                return std::nullopt;
            }
            room = *here;
            free = freeWay();
            lookedM = goneM;
            surelyToM = goneM + room.least() / swings;
        }
    }
    const double movedM = swings * (lengthM - lookedM);
    room = {room.edgesM - movedM, room.cornersM - movedM};
    return at;
}

bool Rig::isOutsideAtAnEnd(RigState state, const Curve& turn) const {
    for (const CurvePiece& piece : turn.pieces) {
        if (stepsFor(piece) || piece.onTheSpot != Angle{}) {
            return false;
        }
        state = stateAfter(state, state, piece, piece.length);
        if (roomAt(state, -kContactM).least() < -kContactM) {
            return true;
        }
    }
    return false;
}

std::optional<RigState> Rig::driven(const RigState& from, const Curve& turn, FootprintRoom room) const {
    // A turn on the spot begins with another heading than requested.
    RigState state = trailer_ ? RigState{turn.start, from.implement} : inLine(turn.start);
    if (turn.pieces.size() > 1 && isOutsideAtAnEnd(state, turn)) {
        return std::nullopt;
    }
    for (const CurvePiece& piece : turn.pieces) {
        const auto next = drivenOn(state, piece, metres(kContactM), room);
        if (!next) {
            return std::nullopt;
        }
        state = *next;
    }
    return state;
}

bool Rig::mayTurnOnTheSpot(const Pose& from, Angle turn) const {
    const double wholeRad = std::abs(turn.si());
    for (double turnedRad = 0.0; turnedRad < wholeRad;) {
        const Pose at{.position = from.position,
                      .heading = from.heading + radians(std::copysign(turnedRad, turn.si()))};
        const double room = roomM(inLine(at));
        if (room < -kContactM) {
            return false;
        }
        turnedRad += std::max(kSpotStepRad, room / tractorRadiusM_);
    }
    return true;
}

bool Rig::mayStandAt(Point point, Length clearance) const {
    const auto isClear = [point](const BoundaryDistance& edges, Length least) {
        const auto inside = edges.insideM(point);
        return !inside || *inside >= least.si() - kContactM;
    };
    const Length wheels = 0.5 * machine_.spec().tractor.width;
    return edges_.hasOverhang() ? isClear(edges_.tractor(), wheels) && isClear(edges_.implement(), clearance)
                                : isClear(edges_.tractor(), std::max(wheels, clearance));
}

}  // namespace furrow
