#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/traversal.h"
#include "planner/turns/manoeuvre_search.h"

namespace furrow {

/// The inputs for the cost of ways.
struct TravelTask {
    const MultiPolygon& workable;  ///< the field less its obstacles
    const MultiPolygon& mainland;
    const Machine& machine;
    Length margin;
};

/// The cost of places by the rule. A place to be avoided costs eight times as much, so a way that must cross
/// such places crosses them as briefly as possible. Turns may reach into the mainland by the length that they
/// need at a swath's end. Empty if everything may be crossed. Cost: one offset and a grid of at most a
/// million cells of 1 m or more. Cancelled.
Result<TravelCost> travelRule(Traversal rule, const TravelTask& task, const JobContext& job);

}  // namespace furrow
