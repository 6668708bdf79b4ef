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
// Steps of a hitch, as a share of what trails behind it: the track is then within a millimetre.
constexpr double kTrailingStep = 0.05;
// What is hardly behind its hitch swings with it.
constexpr double kLeastTrailingM = 0.1;

/// Which way a trailed implement points after its hitch has moved straight by `way`: tan of half the angle
/// between them falls with exp(-way / length), the tractrix.
double trailedHeading(double headingRad, Point way, double trailingM) {
    const double movedM = norm(way);
    if (movedM == 0.0) {
        return headingRad;
    }
    const double towardsRad = std::atan2(way.y, way.x);
    const double angle = std::remainder(headingRad - towardsRad, 2.0 * std::numbers::pi);
    return towardsRad + 2.0 * std::atan(std::tan(0.5 * angle) * std::exp(-movedM / trailingM));
}

double radiusOf(const Ring& shape) {
    double radius = 0.0;
    for (const Point& corner : shape) {
        radius = std::max(radius, norm(corner));
    }
    return radius;
}

bool isTrailed(const Machine& machine) {
    const Implement& implement = machine.spec().implement;
    return implement.mounting == Mounting::Trailed &&
           (implement.hitchOffset - implement.offset).si() > kLeastTrailingM;
}

Ring tractorShape(const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    const double front = (tractor.length - tractor.rearOverhang).si();
    const double rear = -tractor.rearOverhang.si();
    const double half = 0.5 * tractor.width.si();
    return {{rear, -half}, {front, -half}, {front, half}, {rear, half}};
}

/// The raised implement with its hitch at the origin.
Ring trailedShape(const Machine& machine) {
    const Implement& implement = machine.spec().implement;
    const double middle = (implement.offset - implement.hitchOffset).si();
    const double halfLength = 0.5 * implement.length.si();
    const double half = 0.5 * implement.raisedWidth.value_or(implement.operatingWidth).si();
    const double aside = implement.lateralOffset.si();
    return {{middle - halfLength, aside - half},
            {middle + halfLength, aside - half},
            {middle + halfLength, aside + half},
            {middle - halfLength, aside + half}};
}

Length reachOf(const Machine& machine) {
    return metres(1.0 + (isTrailed(machine) ? std::max(radiusOf(tractorShape(machine)), radiusOf(trailedShape(machine)))
                                            : radiusOf(machine.turningFootprint())));
}

}  // namespace

Rig::Part Rig::partOf(Ring shape) {
    const double radiusM = radiusOf(shape);
    return {std::move(shape), radiusM};
}

Rig::Rig(const MultiPolygon& drivable, const Machine& machine)
    : machine_{machine},
      tractor_{partOf(isTrailed(machine) ? tractorShape(machine) : machine.turningFootprint())},
      edges_{drivable, reachOf(machine)} {
    if (isTrailed(machine)) {
        const Implement& implement = machine.spec().implement;
        trailed_ = partOf(trailedShape(machine));
        hitchM_ = implement.hitchOffset.si();
        trailingM_ = (implement.hitchOffset - implement.offset).si();
    }
}

double Rig::outsideM(const Part& part, const Pose& pose) const {
    const auto inside = edges_.insideM(pose.position);
    if (!inside || *inside > part.radiusM) {
        return 0.0;
    }
    return furrow::outsideM(pose, part.shape, edges_);
}

double Rig::outsideM(const RigState& state) const {
    double farthest = outsideM(tractor_, state.tractor);
    if (trailed_) {
        const Point hitch = state.tractor.position + hitchM_ * direction(state.tractor.heading.si());
        farthest = std::max(farthest, outsideM(*trailed_, {.position = hitch, .heading = state.implement}));
    }
    return farthest;
}

template <class Visit>
std::optional<RigState> Rig::follow(const RigState& from, const TurnPiece& piece, Length step, const Visit& visit) const {
    const double longest = trailed_ ? std::min(step.si(), kTrailingStep * trailingM_) : step.si();
    const auto steps = std::max(1, static_cast<int>(std::ceil(piece.length.si() / longest)));
    const auto visited = trailed_ ? std::max(1, static_cast<int>(step.si() / longest)) : 1;
    RigState at = from;
    const auto hitchOf = [this](const Pose& pose) { return pose.position + hitchM_ * direction(pose.heading.si()); };
    for (int i = 1; i <= steps; ++i) {
        const Pose pose = advanced(from.tractor, piece, piece.length * (static_cast<double>(i) / steps));
        at.implement = trailed_ ? radians(trailedHeading(at.implement.si(), hitchOf(pose) - hitchOf(at.tractor), trailingM_))
                                : pose.heading;
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
    RigState state = trailed_ ? RigState{turn.start, from.implement} : inLine(turn.start);
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
