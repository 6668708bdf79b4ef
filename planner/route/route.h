#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/settings/settings.h"
#include "planner/swaths/swath.h"
#include "planner/turns/pose.h"

#include <vector>

namespace furrow {

/// One swath as it is driven.
struct RouteStep {
    std::size_t swath = 0;  ///< index into the swath set
    bool reversed = false;  ///< driven from its end to its start

    friend bool operator==(const RouteStep&, const RouteStep&) = default;
};

/// The order and direction in which swaths are driven.
struct Route {
    std::vector<RouteStep> steps;
    Length lengthInPlace;  ///< L_0: swath lengths and the straight distances between them

    friend bool operator==(const Route&, const Route&) = default;
};

/// Where a step begins and ends, as poses of the vehicle.
Pose startPose(const RouteStep& step, const SwathSet& swaths);
Pose endPose(const RouteStep& step, const SwathSet& swaths);

/// L_0 of the paper for this order.
Length lengthInPlace(const std::vector<RouteStep>& steps, const SwathSet& swaths);

/// The common signature of all route methods: every swath exactly once. Cancelled.
using RoutePlanner = Result<Route>(const SwathSet& swaths, const Machine& machine, const Settings& settings,
                                   const JobContext& job);

}  // namespace furrow
