#include "planner/turns/straight_turn.h"

#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// A smaller difference of headings is rounding.
constexpr double kNoTurnRad = 1e-6;

}  // namespace

Curve straightTurn(const Pose& from, const Pose& to) {
    const Point way = to.position - from.position;
    const double lengthM = norm(way);
    const Angle heading = lengthM > 0.0 ? radians(std::atan2(way.y, way.x)) : from.heading;
    return {.type = "straight",
            .start = {.position = from.position, .heading = heading},
            .pieces = {{.length = metres(lengthM), .curvature = {}}}};
}

bool canTurnOnTheSpot(const Machine& machine) {
    return machine.spec().tractor.canTurnInPlace && machine.spec().implement.mounting != Mounting::Trailed;
}

Duration fromStandToStand(Length way, const Machine& machine) {
    const double mps = machine.spec().tractor.turningSpeed.si();
    const double acceleration = machine.spec().tractor.maxAcceleration.si();
    return seconds(way.si() > mps * mps / acceleration ? way.si() / mps + mps / acceleration
                                                       : 2.0 * std::sqrt(way.si() / acceleration));
}

Duration turningOnTheSpot(Angle turn, const Machine& machine) {
    return fromStandToStand(0.5 * std::abs(turn.si()) * machine.spec().tractor.width, machine);
}

Duration turningOnTheSpot(const Pose& from, const Pose& to, const Machine& machine) {
    const Angle turn = wrappedAngle(to.heading - from.heading);
    return std::abs(turn.si()) > kNoTurnRad ? turningOnTheSpot(turn, machine) : Duration{};
}

Duration turningOnTheSpot(const Curve& way, const Pose& from, const Pose& to, const Machine& machine) {
    return turningOnTheSpot(from, way.start, machine) + turningOnTheSpot(way.end(), to, machine);
}

Duration roughDuration(const Curve& way, const Pose& from, const Pose& to, const Machine& machine) {
    const Duration first = turningOnTheSpot(from, way.start, machine);
    const Duration last = turningOnTheSpot(way.end(), to, machine);
    const bool isStraight = std::ranges::all_of(way.pieces, [](const CurvePiece& piece) {
        return piece.curvature == Curvature{} && piece.endCurvature == Curvature{} &&
               piece.gear == Gear::Forward;
    });
    if (!isStraight || first == Duration{} || last == Duration{}) {
        return first + roughDuration(way, machine) + last;
    }
    Duration sum = first + last;
    for (const CurvePiece& piece : way.pieces) {
        sum += piece.onTheSpot != Angle{} ? turningOnTheSpot(piece.onTheSpot, machine)
                                          : fromStandToStand(piece.length, machine);
    }
    return sum;
}

Duration drivenDuration(const Curve& way, const Pose& from, const Pose& to, const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    const Duration time = roughDuration(way, from, to, machine);
    return isDrivenAsTransfer(way, machine) ? time * (tractor.turningSpeed / tractor.transferSpeed) : time;
}

const Method<TurnPlanner> kStraightMethod{
    .info = {.id = "straight",
             .name = "On the spot",
             .description =
                 "Turns in place and drives straight to the next swath; only for machines that can.",
             .parameters = {}},
    .run = [](const Pose& from, const Pose& to, const Machine&) { return straightTurn(from, to); },
    .traits = {.isStanding = true}};

}  // namespace furrow
