#include "planner/headland/turning_room.h"

#include "planner/turns/turn_sampling.h"

#include <algorithm>
#include <cmath>

namespace furrow {

Length roomForTurns(const Machine& machine, TurnPlanner* turn) {
    constexpr double kStepDeg = 15.0;
    const double widthM = machine.operatingWidth().si();
    const Ring footprint = machine.turningFootprint();
    double deepestM = 0.0;
    //   edge of the mainland, through both swath ends
    //        ___B
    //    A---   |      from A facing north to B facing south
    //    |      |
    for (double angleDeg = 45.0; angleDeg <= 135.0; angleDeg += kStepDeg) {
        const double angle = degrees(angleDeg).si();
        const Point outward{-std::cos(angle), std::sin(angle)};
        const Pose from{.position = {0.0, 0.0}, .heading = degrees(90.0)};
        const Pose to{.position = {widthM, widthM / std::tan(angle)}, .heading = degrees(-90.0)};
        for (const TurnSample& sample : sampled(turn(from, to, machine), kChordTolerance)) {
            for (const Point& corner : placed(footprint, sample.pose)) {
                deepestM = std::max(deepestM, dot(outward, corner));
            }
        }
    }
    return metres(deepestM);
}

}  // namespace furrow
