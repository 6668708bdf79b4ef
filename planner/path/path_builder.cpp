#include "planner/path/path_builder.h"

#include "planner/path/speed_profile.h"
#include "planner/turns/connection.h"

#include <cmath>

namespace furrow {

namespace {

// Legs that meet closer than this need no connection.
constexpr double kSamePlaceM = 1e-6;
constexpr double kSameHeadingRad = 1e-9;

bool isSamePose(const Pose& a, const Pose& b) {
    return distance(a.position, b.position) < kSamePlaceM &&
           dot(direction(a.heading.si()), direction(b.heading.si())) > 1.0 - kSameHeadingRad;
}

}  // namespace

std::vector<Leg> swathLegs(const SwathSet& swaths, const Route& route, const Machine& machine) {
    std::vector<Leg> legs;
    legs.reserve(route.steps.size());
    for (const RouteStep& step : route.steps) {
        const Swath& swath = swaths.swaths[step.swath];
        legs.push_back({.kind = SegmentKind::Swath,
                        .number = swath.number,
                        .line = {.type = {},
                                 .start = vehicleAt(startPose(step, swaths), machine),
                                 .pieces = {{.length = swath.length(), .curvature = {}}}}});
    }
    return legs;
}

Result<Path> buildPath(std::span<const Leg> legs, const Machine& machine, TurnPlanner* turn, const JobContext& job) {
    std::vector<Leg> all;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        all.push_back(legs[i]);
        if (i + 1 == legs.size()) {
            break;
        }
        const Pose leaving = legs[i].line.end();
        const Pose arriving = legs[i + 1].line.start;
        if (!isSamePose(leaving, arriving)) {
            all.push_back({.kind = SegmentKind::Turn,
                           .number = 0,
                           .line = connection(leaving, arriving, machine, turn),
                           .implementDown = false});
        }
    }
    return withSpeeds(all, machine);
}

}  // namespace furrow
