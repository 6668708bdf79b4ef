#include "planner/headland/turning_room.h"

#include "planner/geometry/curve_sampling.h"
#include "planner/turns/connection.h"
#include "planner/turns/trailer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

namespace {

/// The distance of the footprint from the edge of the mainland on the turn from one swath to the next. The
/// edge meets the swaths at `angle`. The implement may be deeper by the overhang.
double depthM(const Machine& machine, TurnPlanner* turn, double angle, bool drawnOut, Length overhang) {
    const double widthM = machine.operatingWidth().si();
    const Point outward{-std::cos(angle), std::sin(angle)};
    // The tractor is ahead of the implement, both when the implement leaves the mainland and when it comes
    // back.
    const double leadM = -machine.spec().implement.offset.si();
    const double moreM = drawnOut ? 0.5 * widthM / std::abs(std::tan(angle)) : 0.0;
    //   edge of the mainland, through both swath ends
    //        ___B
    //    A---   |      from A facing north to B facing south
    //    |      |
    const Pose from{.position = {0.0, moreM + leadM}, .heading = degrees(90.0)};
    const Pose to{.position = {widthM, widthM / std::tan(angle) + moreM - leadM}, .heading = degrees(-90.0)};
    const Ring footprint = machine.turningFootprint();
    const Ring tractor = overhang > Length{} ? tractorOutline(machine) : Ring{};
    double deepestM = 0.0;
    for (const CurveSample& sample : sampled(connection(from, to, machine, turn), kChordTolerance)) {
        for (const Point& corner : placed(footprint, sample.pose)) {
            deepestM = std::max(deepestM, dot(outward, corner) - overhang.si());
        }
        for (const Point& corner : placed(tractor, sample.pose)) {
            deepestM = std::max(deepestM, dot(outward, corner));
        }
    }
    return deepestM;
}

}  // namespace

Length roomForTurns(const Machine& machine, TurnPlanner* turn, bool drawnOut, Length overhang) {
    constexpr double kStepDeg = 15.0;
    double deepestM = 0.0;
    for (double angleDeg = 45.0; angleDeg <= 135.0; angleDeg += kStepDeg) {
        deepestM = std::max(deepestM, depthM(machine, turn, degrees(angleDeg).si(), drawnOut, overhang));
    }
    return metres(deepestM);
}

Length roomForTurnsAt(Angle angle, const Machine& machine, TurnPlanner* turn, bool drawnOut,
                      Length overhang) {
    const double flattest = degrees(15.0).si();
    const double acute =
        std::clamp(std::min(angle.si(), std::numbers::pi - angle.si()), flattest, 0.5 * std::numbers::pi);
    return metres(std::max(depthM(machine, turn, acute, drawnOut, overhang),
                           depthM(machine, turn, std::numbers::pi - acute, drawnOut, overhang)));
}

Length reachOfLevelTurn(const Machine& machine, TurnPlanner* turn) {
    return metres(depthM(machine, turn, 0.5 * std::numbers::pi, false, {}));
}

}  // namespace furrow
