#pragma once

#include "planner/plan/plan_chooser.h"
#include "planner/plan/plan_to_beat.h"
#include "planner/plan/stage_runner.h"

namespace furrow {

/// Plans the request and its alternatives, and takes the best plan. The plan with fewer blocking findings is
/// better. Of equal ones the quicker is better: the time of the driven path, with the time to work separately
/// what it leaves. Alternatives are:
///
/// - headings, for searches by time: the longest edge, and more headings of the search if the plan cannot be
/// driven.
/// - orders, for `route.method=optimised`: boustrophedon and snake, of few swaths all patterns, if their
///   estimate is close.
/// - corners of the headland, for `headland.corner=quickest`: all kinds, if the plan can be driven.
/// - one width for all edges, for `headland.method=per-edge`, and one heading for all cells, for
///   `decomposition.heading=per-cell`. Each is compared with its own best heading, order and corners. A route
///   in an order by hand keeps its swaths.
///
/// Plan::instead names each choice that was replaced. A note tells it, except for orders and corners, which
/// nobody asked for. BestSoFar::asked holds what was decided beside headings, orders and corners. Cost: one
/// plan for each alternative. Plans that cannot win are not audited. Errors: those of the request. Cancelled.
Result<BestSoFar> quickestChoice(const PlanRequest& request, StageRunner& runner, const JobContext& job,
                                 ChoosingCourse course = {});

}  // namespace furrow
