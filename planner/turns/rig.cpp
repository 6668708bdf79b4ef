#include "planner/turns/rig.h"

#include "planner/turns/footprint_check.h"
#include "planner/turns/turn_sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

// Outside by less than this is touching.
constexpr double kTouchingM = 1e-3;

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

double Rig::outsideM(const Part& part, const Pose& pose) const {
    const auto inside = edges_.insideM(pose.position);
    if (!inside || *inside > part.radiusM) {
        return 0.0;
    }
    return furrow::outsideM(pose, part.shape, edges_);
}

double Rig::outsideM(const RigState& state) const {
    const double farthest = outsideM(tractor_, state.tractor);
    return trailer_ ? std::max(farthest, outsideM(trailed_, trailer_->poseOf(state.tractor, state.implement)))
                    : farthest;
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

std::optional<RigState> Rig::driven(const RigState& from, const TurnPiece& piece, Length step) const {
    return follow(from, piece, step, [this](const RigState& state) { return outsideM(state) <= kTouchingM; });
}

std::optional<RigState> Rig::driven(const RigState& from, const Turn& turn, Length step) const {
    // A turn on the spot begins with another heading than it was asked for.
    RigState state = trailer_ ? RigState{turn.start, from.implement} : inLine(turn.start);
    for (const TurnPiece& piece : turn.pieces) {
        const auto next = driven(state, piece, step);
        if (!next) {
            return std::nullopt;
        }
        state = *next;
    }
    return state;
}

bool Rig::mayStandAt(Point point) const {
    const auto inside = edges_.insideM(point);
    return !inside || *inside >= 0.5 * machine_.spec().tractor.width.si() - kTouchingM;
}

}  // namespace furrow
