#include "planner/turns/straight_turn.h"

#include "planner/units/angle.h"

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

Duration turningOnTheSpot(Angle turn, const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    const double wayM = 0.5 * tractor.width.si() * std::abs(turn.si());
    const double mps = machine.turningSpeed().si();
    const double acceleration = tractor.maxAcceleration.si();
    return seconds(wayM > mps * mps / acceleration ? wayM / mps + mps / acceleration
                                                   : 2.0 * std::sqrt(wayM / acceleration));
}

Duration turningOnTheSpot(const Pose& from, const Pose& to, const Machine& machine) {
    const Angle turn = wrappedAngle(to.heading - from.heading);
    return std::abs(turn.si()) > kNoTurnRad ? turningOnTheSpot(turn, machine) : Duration{};
}

Duration turningOnTheSpot(const Curve& way, const Pose& from, const Pose& to, const Machine& machine) {
    return turningOnTheSpot(from, way.start, machine) + turningOnTheSpot(way.end(), to, machine);
}

Duration roughDuration(const Curve& way, const Pose& from, const Pose& to, const Machine& machine) {
    return roughDuration(way, machine) + turningOnTheSpot(way, from, to, machine);
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
