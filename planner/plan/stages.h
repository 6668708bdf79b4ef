#pragma once

#include "planner/audit/audit.h"
#include "planner/decomposition/decomposition.h"
#include "planner/field/allowed_areas.h"
#include "planner/headland/headland.h"
#include "planner/path/finding.h"
#include "planner/path/path.h"
#include "planner/path/tank_levels.h"
#include "planner/plan/plan_request.h"
#include "planner/route/route.h"
#include "planner/swaths/swath.h"

#include <memory>
#include <optional>
#include <vector>

namespace furrow {

// The stages of a plan, each a function from values to a value (DESIGN 47):
//
//     PlanRequest -> Ground -> Headland -> LaidSwaths -> Ordered -> Driven

/// Where the machine may be.
struct Ground {
    Length margin;  ///< that everything keeps from the boundary: the setting, or the boundary's accuracy
    AllowedAreas drivable;  ///< gates closed
    /// For the implement, without the margin; empty if that is the field's drivable area.
    std::optional<MultiPolygon> overhung;
};

/// A part of the mainland whose swaths were laid, and are decomposed, by themselves.
struct MainlandPart {
    MultiPolygon outline;
    std::size_t firstSwath = 0;  ///< of the set; a part's swaths follow on each other
    std::size_t swathCount = 0;
    std::optional<Angle> heading;  ///< where it is not that of the set

    friend bool operator==(const MainlandPart&, const MainlandPart&) = default;
};

/// The swaths of a mainland.
struct LaidSwaths {
    SwathSet swaths;
    std::vector<MainlandPart> parts;  ///< tile the mainland
    MultiPolygon mainland;            ///< obstacles that swaths go round are holes of it, and of no part
    /// As they were before they were led round obstacles, which is no matter for cells; empty where none is.
    std::optional<SwathSet> beforeRound = {};

    const SwathSet& forCells() const { return beforeRound ? *beforeRound : swaths; }
};

/// Swaths that were led round obstacles.
struct RoundedSwaths {
    LaidSwaths laid;
    std::vector<std::size_t> refused;  ///< obstacles that some swath does not get round, by index, rising
};

/// Headland and swaths that fit together.
struct LaidOut {
    std::shared_ptr<const Headland> headland;
    std::shared_ptr<const LaidSwaths> laid;
};

/// The swaths in cells, and the order in which they are driven.
struct Ordered {
    Decomposition cells;
    Route route;
};

/// The tank or bunker that a path follows, and where it is filled or emptied.
struct RefillTrips {
    TankWork work;
    std::vector<Point> points;

    friend bool operator==(const RefillTrips&, const RefillTrips&) = default;
};

/// The path over all of it, and what is found along it.
struct Driven {
    Path path;
    std::vector<HeadlandPass> finishing;  ///< short passes over what others leave
    /// Land that may be driven on and is not worked on purpose: wet spots, what is passed over with them,
    /// alleys, gaps.
    MultiPolygon leftOnPurpose;
    AuditReport audit;  ///< empty of a draft
    std::vector<Finding> findings;
    std::optional<RefillTrips> refill = {};  ///< if refill points are given and the work needs a tank
    Area leftBeforeFinishing;                ///< within reach; none where no finishing passes were needed
    Duration finishingCost;                  ///< what they added to the time for all
    Duration auditing;                       ///< wall time for the audits of the path
};

}  // namespace furrow
