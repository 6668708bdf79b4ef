#pragma once

#include "planner/headland/full_lock_passes.h"
#include "planner/path/drivable_check.h"
#include "planner/path/fitting_ways.h"
#include "planner/path/steerable_legs.h"
#include "planner/plan/plan_request.h"
#include "planner/plan/stage_memo.h"
#include "planner/plan/stages.h"
#include "planner/settings/traversal.h"

#include <memory>

namespace furrow {

/// What a driving room is made from, beside field and machine.
struct DrivingRoomInputs {
    std::shared_ptr<const Ground> ground;
    AllowedAreas forWays;   ///< gates open
    MultiPolygon mainland;  ///< for the rule
    Traversal traversal{};

    friend bool operator==(const DrivingRoomInputs&, const DrivingRoomInputs&) = default;
};

/// The area in which a machine drives, with the ways that were searched, the lines that were eased, the ways
/// that were tested and the bends that were tried in it. Plans that differ by headings, order or corners
/// share them. Thread-safe.
struct DrivingRoom {
    std::shared_ptr<WaySearches> raised;
    std::shared_ptr<WaySearches> folded;  ///< the same as `raised` for machines that do not fold
    SteeringRoom steering;
    std::shared_ptr<WayChecks> checks;
    std::shared_ptr<FullLockTrials> bends;
};

using DrivingRooms = StageMemo<DrivingRoomInputs, DrivingRoom, 4>;

/// Cancelled.
Result<std::shared_ptr<const DrivingRoom>> drivingRoom(DrivingRooms& known, const PlanRequest& request,
                                                       DrivingRoomInputs inputs, const JobContext& job);

}  // namespace furrow
