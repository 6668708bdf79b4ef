#include "planner/turns/turn.h"

#include "planner/units/angle.h"

#include <cmath>

namespace furrow {

Length Turn::length() const {
    Length sum;
    for (const TurnPiece& piece : pieces) {
        sum += piece.length;
    }
    return sum;
}

Pose Turn::end() const {
    Pose pose = start;
    for (const TurnPiece& piece : pieces) {
        pose = advanced(pose, piece, piece.length);
    }
    return pose;
}

Pose advanced(const Pose& from, const TurnPiece& piece, Length way) {
    const double signedWay = piece.gear == Gear::Forward ? way.si() : -way.si();
    const double turned = signedWay * piece.curvature.si();
    // The chord of an arc leaves at half its angle; sin(x)/x keeps flat arcs exact.
    const double half = 0.5 * turned;
    const double chord = std::abs(half) < 1e-9 ? signedWay : signedWay * std::sin(half) / half;
    return {.position = from.position + chord * direction(from.heading.si() + half),
            .heading = normalisedPoseHeading(from.heading + radians(turned))};
}

}  // namespace furrow
