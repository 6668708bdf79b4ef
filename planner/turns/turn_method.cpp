#include "planner/turns/turn_method.h"

#include "planner/turns/manoeuvre_search.h"
#include "planner/turns/straight_turn.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

constexpr double kTransferRadii = 8.0;
constexpr double kTransferWidths = 4.0;

/// What braking to a stop and getting under way again takes longer than driving on.
Duration stopDuration(const Machine& machine) {
    return seconds(machine.spec().tractor.turningSpeed.si() / machine.spec().tractor.maxAcceleration.si());
}

/// As wanted, or less where the lateral acceleration would be too large.
Speed speedOn(const CurvePiece& piece, const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    if (piece.gear == Gear::Reverse) {
        return tractor.reverseSpeed;
    }
    const double bend = std::max(std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si()));
    return std::min(tractor.turningSpeed,
                    metresPerSecond(std::sqrt(tractor.maxLateralAcceleration.si() / bend)));
}

}  // namespace

Length longestTurn(const Machine& machine) {
    return kTransferRadii * machine.minTurningRadius() + kTransferWidths * machine.operatingWidth();
}

bool isDrivenAsTransfer(const Curve& way, const Machine& machine) {
    const bool mayBeLong = way.type == kCombinedTurn || way.type == kStraightMethod.info.id;
    return mayBeLong && way.length() > longestTurn(machine);
}

Duration gearChangeDuration(const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    return seconds((machine.turningSpeed() + tractor.reverseSpeed).si() /
                   (2.0 * tractor.maxAcceleration.si()));
}

Duration roughDuration(const Curve& turn, const Machine& machine) {
    Duration sum;
    const CurvePiece* before = nullptr;
    for (const CurvePiece& piece : turn.pieces) {
        if (piece.onTheSpot != Angle{}) {
            sum += stopDuration(machine) + turningOnTheSpot(piece.onTheSpot, machine);
            continue;
        }
        if (before != nullptr && before->gear != piece.gear) {
            sum += gearChangeDuration(machine);
        }
        before = &piece;
        sum += seconds(piece.length.si() / speedOn(piece, machine).si());
    }
    return sum;
}

}  // namespace furrow
