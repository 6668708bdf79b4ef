#pragma once

#include "planner/plan/plan.h"

namespace furrow {

/// The plan as asked, or the one with a simpler choice where that is quicker as driven: a choice that promises time is
/// only taken where it gives time. Compared are the times of the driven paths, and of working by itself what one leaves
/// and the other does not; a plan with fewer blocking findings comes first.
///
/// Tried are: one width all round instead of `headland.method=per-edge`, one heading for all cells instead of
/// `decomposition.heading=per-cell`, and other headings that the search by time found: along the longest edge where its
/// estimate is near the best, and all of them where the best cannot be driven. An order of one's own keeps its swaths.
/// With `headland.corner=quickest` a drivable plan is compared with those that reach into the corners of the headland.
/// What was taken stands in Plan::instead; a note says so, but for corners, of which none was asked for.
/// Cost: a plan for each. Errors: of the plan as asked. Cancelled.
Result<std::shared_ptr<Plan>> quickestChoice(const PlanRequest& request, const JobContext& job);

/// Seconds: the driven path, and what it leaves within the field worked by itself. Areas that are left on purpose cost
/// nothing.
Duration timeForAll(const Plan& plan);

}  // namespace furrow
