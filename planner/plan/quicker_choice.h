#pragma once

#include "planner/plan/plan_to_beat.h"
#include "planner/plan/stage_runner.h"

namespace furrow {

/// The stages of the plan that was chosen.
struct QuickestChoice {
    PlannedStages stages;
    std::vector<SettingChange> instead;      ///< see Plan::instead
    std::vector<Note> notes;                 ///< why
    std::vector<HeadingCandidate> headings;  ///< of the search, of which one was taken
};

/// The plan as asked, with what is left to the planner, and what promises time, decided by the time of the
/// driven path: what one plan leaves and the other does not counts as worked by itself; a plan with fewer
/// blocking findings comes first.
///
/// - Heading, of searches by time: along the longest edge as well; where the plan cannot be driven, other
/// headings that
///   the search found, too.
/// - Order, of `route.method=optimised`: boustrophedon and snake, where their turns are about as quick by the
/// estimate.
/// - Corners, of `headland.corner=quickest`: those that reach into the corners of the headland, of drivable
/// plans.
/// - `headland.method=per-edge` and `decomposition.heading=per-cell`: one width all round, one heading for
/// all cells, each
///   with all of the above. An order of one's own keeps its swaths.
///
/// What was taken stands in Plan::instead; a note says so, but for orders and corners, of which none was
/// asked for. Cost: a plan for each; those that are slower for sure are not audited. Errors: of the plan as
/// asked. Cancelled.
Result<QuickestChoice> quickestChoice(const PlanRequest& request, StageRunner& runner, const JobContext& job);

}  // namespace furrow
