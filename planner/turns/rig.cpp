#include "planner/turns/rig.h"

#include "planner/turns/footprint_check.h"
#include "planner/turns/turn_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

// A place whose wheels are outside by less is inside.
constexpr double kTouchingM = 1e-3;
// What is flush with an edge is looked at no more often than this; in bends beside a corner of the field so often that
// it cannot pass through a corner of the footprint unseen.
constexpr double kLookOnStraightM = 0.2;
constexpr double kLookInBendM = 0.05;
constexpr double kLookAtCornersM = 0.01;
constexpr double kRoundingM = 1e-9;

double radiusOf(const Ring& shape) {
    double radius = 0.0;
    for (const Point& corner : shape) {
        radius = std::max(radius, norm(corner));
    }
    return radius;
}

Ring wholeFootprint(const Machine& machine, ImplementAt implement) {
    return implement == ImplementAt::Lowered ? machine.workingFootprint() : machine.turningFootprint();
}

Ring tractorShape(const Machine& machine, const std::optional<Trailer>& trailer, ImplementAt implement) {
    return trailer ? tractorOutline(machine) : wholeFootprint(machine, implement);
}

Ring trailedShape(const std::optional<Trailer>& trailer, ImplementAt implement) {
    return !trailer ? Ring{} : implement == ImplementAt::Lowered ? trailer->lowered : trailer->raised;
}

}  // namespace

Rig::Part Rig::partOf(Ring shape) {
    const double radiusM = radiusOf(shape);
    return {std::move(shape), radiusM};
}

Rig::Rig(const MultiPolygon& drivable, const Machine& machine, ImplementAt implement)
    : machine_{machine},
      trailer_{Trailer::of(machine)},
      tractor_{partOf(tractorShape(machine, trailer_, implement))},
      trailed_{partOf(trailedShape(trailer_, implement))},
      edges_{drivable, metres(1.0 + std::max(tractor_.radiusM, trailed_.radiusM))} {}

FootprintRoom Rig::roomAround(const Part& part, const Pose& pose) const {
    const double inside = edges_.insideM(pose.position).value_or(edges_.reachM());
    if (inside > part.radiusM) {
        return {inside - part.radiusM, inside - part.radiusM};
    }
    return furrow::roomAround(pose, part.shape, edges_);
}

FootprintRoom Rig::roomAround(const RigState& state) const {
    const FootprintRoom tractor = roomAround(tractor_, state.tractor);
    if (!trailer_) {
        return tractor;
    }
    const FootprintRoom trailed = roomAround(trailed_, trailer_->poseOf(state.tractor, state.implement));
    return {std::min(tractor.edgesM, trailed.edgesM), std::min(tractor.cornersM, trailed.cornersM)};
}

double Rig::crossedM(const Part& part, const Pose& pose) const {
    if (edges_.insideM(pose.position).value_or(edges_.reachM()) > part.radiusM) {
        return 0.0;
    }
    return edges_.crossedM(pose.position, placed(part.shape, pose));
}

double Rig::crossedM(const RigState& state) const {
    const double tractor = crossedM(tractor_, state.tractor);
    return trailer_ ? std::max(tractor, crossedM(trailed_, trailer_->poseOf(state.tractor, state.implement))) : tractor;
}

double Rig::roomM(const RigState& state) const {
    const double room = roomAround(state).least();
    if (room < 0.0) {
        return room;
    }
    // What is long and thin crosses the sides without a corner of either in the other.
    const double crossed = crossedM(state);
    return crossed > 0.0 ? -crossed : room;
}

std::optional<RigState> Rig::follow(const RigState& from, const TurnPiece& piece, Length step,
                                    const std::function<bool(const RigState&)>& visit) const {
    const Length longest = trailer_ ? std::min(step, trailer_->longestStep()) : step;
    const auto steps = std::max(1, static_cast<int>(std::ceil(piece.length / longest)));
    const auto visited = trailer_ ? std::max(1, static_cast<int>(step / longest)) : 1;
    RigState at = from;
    for (int i = 1; i <= steps; ++i) {
        const Pose pose = advanced(from.tractor, piece, piece.length * (static_cast<double>(i) / steps));
        at.implement = trailer_ ? trailer_->headingAfter(at.implement, at.tractor, pose) : pose.heading;
        at.tractor = pose;
        if ((i % visited == 0 || i == steps) && !visit(at)) {
            return std::nullopt;
        }
    }
    return at;
}

std::optional<RigState> Rig::driven(const RigState& from, const TurnPiece& piece, Length touching) const {
    // No point of it moves by more than this for each metre of the way.
    const double bent = std::max(std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si()));
    const double swings = std::max(1.0 + bent * tractor_.radiusM, trailer_ ? 1.0 + trailed_.radiusM / trailer_->trailingM : 0.0);
    const bool isStraight = bent == 0.0;
    const auto freeWay = [&](const FootprintRoom& room) {
        const double alongEdges = std::max(room.edgesM / swings, isStraight ? kLookOnStraightM : kLookInBendM);
        const double atCorners = std::max(room.cornersM / swings, isStraight ? kLookInBendM : kLookAtCornersM);
        return std::min(alongEdges, atCorners);
    };
    RigState at = from;
    const double lengthM = piece.length.si();
    double free = 0.0;  // of the way ahead
    for (double goneM = 0.0; goneM < lengthM;) {
        double stepM = std::min(std::max(free, kLookAtCornersM), lengthM - goneM);
        if (trailer_) {
            stepM = std::min(stepM, trailer_->longestStep().si());
        }
        goneM = lengthM - goneM - stepM < kRoundingM ? lengthM : goneM + stepM;
        const Pose pose = advanced(from.tractor, piece, metres(goneM));
        at.implement = trailer_ ? trailer_->headingAfter(at.implement, at.tractor, pose) : pose.heading;
        at.tractor = pose;
        free -= stepM;
        if (free <= kRoundingM || goneM == lengthM) {
            const FootprintRoom room = roomAround(at);
            // With its own corners along an edge and a corner of the field along its side, an edge may come in between.
            if (room.least() < -touching.si() || (room.least() < kLookAtCornersM && crossedM(at) > touching.si())) {
                return std::nullopt;
            }
            free = freeWay(room);
        }
    }
    return at;
}

std::optional<RigState> Rig::driven(const RigState& from, const Turn& turn) const {
    // A turn on the spot begins with another heading than it was asked for.
    RigState state = trailer_ ? RigState{turn.start, from.implement} : inLine(turn.start);
    for (const TurnPiece& piece : turn.pieces) {
        const auto next = driven(state, piece);
        if (!next) {
            return std::nullopt;
        }
        state = *next;
    }
    return state;
}

bool Rig::mayStandAt(Point point, Length clearance) const {
    const auto inside = edges_.insideM(point);
    return !inside || *inside >= std::max(0.5 * machine_.spec().tractor.width, clearance).si() - kTouchingM;
}

}  // namespace furrow
