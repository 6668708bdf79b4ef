#include "planner/turns/connection.h"

#include "planner/turns/straight_turn.h"

#include <cmath>

namespace furrow {

namespace {

bool isStraightAhead(const Pose& from, const Pose& to) {
    const Point ahead = direction(from.heading.si());
    const Point way = to.position - from.position;
    return dot(ahead, direction(to.heading.si())) > 1.0 - 1e-12 && std::abs(cross(ahead, way)) < 1e-6 &&
           dot(ahead, way) >= 0.0;
}

}  // namespace

Pose vehicleAt(const Pose& implement, const Machine& machine) {
    const Point ahead = direction(implement.heading.si());
    const Point left{-ahead.y, ahead.x};
    const Implement& spec = machine.spec().implement;
    return {.position = implement.position - spec.offset.si() * ahead - spec.lateralOffset.si() * left,
            .heading = implement.heading};
}

Curve connection(const Pose& leaving, const Pose& arriving, const Machine& machine, TurnPlanner* turn) {
    const double runInM = machine.runIn().si();
    if (runInM > 0.0 && !isStraightAhead(leaving, arriving)) {
        const Pose before{.position = arriving.position - runInM * direction(arriving.heading.si()),
                          .heading = arriving.heading};
        Curve made = turn(leaving, before, machine);
        if (made.type != kStraightMethod.info.id) {
            made.pieces.push_back({.length = metres(runInM), .curvature = {}});
            return made;
        }
    }
    return turn(leaving, arriving, machine);
}

}  // namespace furrow
