#include "planner/route/route.h"

#include "planner/geometry/curve_parts.h"
#include "planner/headland/smooth_ring.h"
#include "planner/turns/connection.h"
#include "planner/units/angle.h"

#include <algorithm>

namespace furrow {

namespace {

Angle drivingHeading(const RouteStep& step, const SwathSet& swaths) {
    return normalisedPoseHeading(step.reversed ? swaths.heading + degrees(180.0) : swaths.heading);
}

Pose turnedRound(const Pose& pose) {
    return {.position = pose.position, .heading = normalisedPoseHeading(pose.heading + degrees(180.0))};
}

}  // namespace

Pose startPose(const RouteStep& step, const SwathSet& swaths) {
    const Swath& swath = swaths.swaths[step.swath];
    if (swath.isCurved()) {
        return step.reversed ? turnedRound(swath.curve.end()) : swath.curve.start;
    }
    return {.position = step.reversed ? swath.end : swath.start, .heading = drivingHeading(step, swaths)};
}

Pose endPose(const RouteStep& step, const SwathSet& swaths) {
    const Swath& swath = swaths.swaths[step.swath];
    if (swath.isCurved()) {
        return step.reversed ? turnedRound(swath.curve.start) : swath.curve.end();
    }
    return {.position = step.reversed ? swath.start : swath.end, .heading = drivingHeading(step, swaths)};
}

Curve drivenLine(const RouteStep& step, const SwathSet& swaths, const Machine& machine) {
    const Swath& swath = swaths.swaths[step.swath];
    if (!swath.isCurved()) {
        return {.type = {},
                .start = vehicleAt(startPose(step, swaths), machine),
                .pieces = {{.length = swath.length(), .curvature = {}}}};
    }
    const Curve along = step.reversed ? reversedLine(swath.curve) : swath.curve;
    const Curve line = movedLeft(along, -machine.spec().implement.lateralOffset);
    const Length lead = -machine.spec().implement.offset;
    const Length length = line.length();
    if (swath.isClosed()) {
        // On a closed ring, the stretch ahead of the start is the ring again.
        Curve twice = line;
        twice.pieces.insert(twice.pieces.end(), line.pieces.begin(), line.pieces.end());
        const Length from = lead < Length{} ? length + lead : lead;
        return partOf(twice, from, from + length);
    }
    const Length beyond = std::max(lead, -lead);
    return partOf(extended(line, beyond, beyond), beyond + lead, beyond + lead + length);
}

Pose vehicleStart(const RouteStep& step, const SwathSet& swaths, const Machine& machine) {
    return swaths.swaths[step.swath].isCurved() ? drivenLine(step, swaths, machine).start
                                                : vehicleAt(startPose(step, swaths), machine);
}

Pose vehicleEnd(const RouteStep& step, const SwathSet& swaths, const Machine& machine) {
    return swaths.swaths[step.swath].isCurved() ? drivenLine(step, swaths, machine).end()
                                                : vehicleAt(endPose(step, swaths), machine);
}

Polyline drivenMiddle(const RouteStep& step, const SwathSet& swaths) {
    const Swath& swath = swaths.swaths[step.swath];
    Polyline line = middleLine(swath);
    if (step.reversed) {
        std::ranges::reverse(line);
    }
    return line;
}

DrivenSwath drivenSwath(const RouteStep& step, const SwathSet& swaths) {
    const Swath& swath = swaths.swaths[step.swath];
    const Point middle = swath.isCurved()
                             ? partOf(swath.curve, Length{}, 0.5 * swath.curve.length()).end().position
                             : 0.5 * (swath.start + swath.end);
    return {.from = step.reversed ? swath.end : swath.start,
            .middle = middle,
            .to = step.reversed ? swath.start : swath.end};
}

Curve turnBetween(const RouteStep& from, const RouteStep& to, const SwathSet& swaths, const Machine& machine,
                  TurnPlanner* turn) {
    return connection(vehicleEnd(from, swaths, machine), vehicleStart(to, swaths, machine), machine, turn);
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
