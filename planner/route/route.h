#pragma once

#include "planner/core/result.h"
#include "planner/geometry/pose.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/route/driven_swath.h"
#include "planner/settings/method.h"
#include "planner/settings/settings.h"
#include "planner/swaths/swath.h"
#include "planner/turns/manoeuvre_search.h"
#include "planner/turns/turn_method.h"

#include <functional>
#include <optional>
#include <vector>

namespace furrow {

/// One swath with its direction of driving.
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

/// The pose of the implement at the beginning and end of a step, facing the direction of driving.
Pose startPose(const RouteStep& step, const SwathSet& swaths);
Pose endPose(const RouteStep& step, const SwathSet& swaths);

/// The line of the vehicle's reference point while the implement is on the swath. Along a curve the reference
/// point itself follows it, as guidance steers, moved sideways by the implement's lateral offset. In a bend
/// of radius R, the middle of an implement at a distance d behind the axle therefore runs outside of it by d²
/// / 2R.
Curve drivenLine(const RouteStep& step, const SwathSet& swaths, const Machine& machine);

/// The pose of the vehicle at the beginning and end of a step: the ends of that line.
Pose vehicleStart(const RouteStep& step, const SwathSet& swaths, const Machine& machine);
Pose vehicleEnd(const RouteStep& step, const SwathSet& swaths, const Machine& machine);

/// The swath in driving direction.
Polyline drivenMiddle(const RouteStep& step, const SwathSet& swaths);

/// The same by three of its points.
DrivenSwath drivenSwath(const RouteStep& step, const SwathSet& swaths);

/// The turn from the end of one step to the start of another, run-in included.
Curve turnBetween(const RouteStep& from, const RouteStep& to, const SwathSet& swaths, const Machine& machine,
                  TurnPlanner* turn);

/// L_0 of the paper for this order.
Length lengthInPlace(const std::vector<RouteStep>& steps, const SwathSet& swaths);

/// The way that a path takes from the end of one step to the start of another one. Empty if none is found
/// with this effort.
using WayInField =
    std::function<std::optional<Curve>(const RouteStep& from, const RouteStep& to, SearchEffort effort)>;

/// The inputs of routes. The routes keep none of them.
struct RouteTask {
    const SwathSet& swaths;
    const Machine& machine;
    TurnPlanner* turn;  ///< turn from swath to swath
    const Settings& settings;
    /// Swaths that are driven together, as indices in the order of the set. Empty: all of them.
    std::vector<std::vector<std::size_t>> cells = {};
    WayInField way = {};              ///< empty: as in free space
    std::optional<Point> start = {};  ///< where the machine comes from
    std::optional<Point> end = {};    ///< where it goes to
    bool isDraft = false;             ///< a first route, at once
    /// The order of a plan of the field as it was before a change, for a draft to go on from.
    std::vector<DrivenSwath> earlier = {};
};

/// The common signature of all route methods: every swath exactly once. InputRefused: a custom order that
/// does not name each of them once. Cancelled.
using RoutePlanner = Result<Route>(const RouteTask& task, const JobContext& job);

template <>
struct MethodTraits<RoutePlanner> {
    bool isByTime = false;  ///< the quickest by its estimated turns
    bool isByHand = false;  ///< the user names the swaths
    bool isPlain = false;   ///< a pattern that every driver knows, with few long ways
};

}  // namespace furrow
