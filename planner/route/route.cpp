#include "planner/route/route.h"

#include "planner/turns/connection.h"
#include "planner/units/angle.h"

namespace furrow {

namespace {

Angle drivingHeading(const RouteStep& step, const SwathSet& swaths) {
    return normalisedPoseHeading(step.reversed ? swaths.heading + degrees(180.0) : swaths.heading);
}

}  // namespace

Pose startPose(const RouteStep& step, const SwathSet& swaths) {
    const Swath& swath = swaths.swaths[step.swath];
    return {.position = step.reversed ? swath.end : swath.start, .heading = drivingHeading(step, swaths)};
}

Pose endPose(const RouteStep& step, const SwathSet& swaths) {
    const Swath& swath = swaths.swaths[step.swath];
    return {.position = step.reversed ? swath.start : swath.end, .heading = drivingHeading(step, swaths)};
}

Turn turnBetween(const RouteStep& from, const RouteStep& to, const SwathSet& swaths, const Machine& machine,
                 TurnPlanner* turn) {
    return connection(vehicleAt(endPose(from, swaths), machine), vehicleAt(startPose(to, swaths), machine),
                      machine, turn);
}

Length lengthInPlace(const std::vector<RouteStep>& steps, const SwathSet& swaths) {
    Length sum;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        sum += swaths.swaths[steps[i].swath].length();
        if (i > 0) {
            sum += metres(
                distance(endPose(steps[i - 1], swaths).position, startPose(steps[i], swaths).position));
        }
    }
    return sum;
}

}  // namespace furrow
