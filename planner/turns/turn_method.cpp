#include "planner/turns/turn_method.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

constexpr double kTransferRadii = 8.0;
constexpr double kTransferWidths = 4.0;

}  // namespace

Length longestTurn(const Machine& machine) {
    return kTransferRadii * machine.minTurningRadius() + kTransferWidths * machine.operatingWidth();
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
        if (before != nullptr && before->gear != piece.gear) {
            sum += gearChangeDuration(machine);
        }
        before = &piece;
        const Speed speed =
            piece.gear == Gear::Forward ? machine.turningSpeed() : machine.spec().tractor.reverseSpeed;
        sum += seconds(piece.length.si() / speed.si());
    }
    return sum;
}

}  // namespace furrow
