#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/traversal.h"
#include "planner/turns/manoeuvre_search.h"

namespace furrow {

/// What ways are measured by.
struct TravelTask {
    const MultiPolygon& workable;  ///< the field less its obstacles
    const MultiPolygon& mainland;
    const Machine& machine;
    Length margin;
};

/// How dear places are by the rule: eight times where ways should not lead, so that a way that has to cross them still
/// does, the shortest possible. Turns may reach into the mainland by as much as they need at a swath's end. Empty where
/// everything may be crossed. Cost: one offset and a grid of at most a million cells of 1 m or more. Cancelled.
Result<TravelCost> travelRule(Traversal rule, const TravelTask& task, const JobContext& job);

}  // namespace furrow
