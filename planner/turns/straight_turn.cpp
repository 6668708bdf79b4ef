#include "planner/turns/straight_turn.h"

#include <cmath>

namespace furrow {

Curve straightTurn(const Pose& from, const Pose& to) {
    const Point way = to.position - from.position;
    const double lengthM = norm(way);
    const Angle heading = lengthM > 0.0 ? radians(std::atan2(way.y, way.x)) : from.heading;
    return {.type = "straight",
            .start = {.position = from.position, .heading = heading},
            .pieces = {{.length = metres(lengthM), .curvature = {}}}};
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
