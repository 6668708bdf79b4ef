#pragma once

#include "planner/plan/plan.h"

#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace furrow {

/// One decision of a plan that the search for the best plan makes. It may take several settings.
struct PlanChoice {
    std::string_view id;    ///< "headland"
    std::string_view name;  ///< as people see it
};

/// Headland, heading, cells, order, last pass, ends of swaths, obstacles, headland passes. What is up to the
/// operation, to safety or to agronomy is none of them: margin, overlap, headland first or last, the ways
/// that may be driven, land that is left on purpose.
std::span<const PlanChoice> planChoices();

/// Whether one of the settings of a choice was given.
bool isGiven(const PlanChoice& choice, const Settings& settings);

struct BestPlanTask {
    PlanRequest request;  ///< plans are compared always, whatever it says of that
    /// Ids of choices that stay as the request has them. An order of one's own keeps all choices that its
    /// swaths depend on.
    std::vector<std::string_view> kept;
    /// Called whenever a better plan is found, and for the plan as asked, with the settings that make it.
    std::function<void(const Settings& settings, Duration time)> onBetter;
};

/// The quickest plan with the table of its choices (Plan::choices). The plan with fewer blocking findings is
/// better; of equal ones the quicker, in the time of the driven path with the time to work separately what it
/// misses.
///
/// From the plan as asked, one choice after the other is changed to each of its alternatives. Each
/// alternative is planned with its own best order and corners, and the best is taken where it saves 0.1 %. It
/// ends when no alternative of any choice is better, or after four rounds. So no single change of a choice
/// that was not kept makes the plan more than 0.1 % quicker, unless the rounds ran out. The settings of the
/// plan hold what was taken; planning them again gives the same plan.
///
/// Cost: about fifty plans, those that fall behind not to their end. Errors: those of the request.
/// Cancelled.
Result<std::shared_ptr<const Plan>> bestPlan(const BestPlanTask& task, const JobContext& job = {},
                                             StageCache* cache = nullptr);

}  // namespace furrow
