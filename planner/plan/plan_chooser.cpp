#include "planner/plan/plan_chooser.h"

#include "planner/decomposition/decomposition.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/jobs/parallel.h"
#include "planner/jobs/shared_progress.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/order_stage.h"
#include "planner/route/methods.h"
#include "planner/route/patterns.h"
#include "planner/route/route_costs.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"
#include "planner/units/time_message.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace furrow {

namespace {

constexpr std::string_view kCompareAlways = "always";
constexpr Choice kComparisons[] = {
    {kCompareAlways, "Always", "The quickest of them is taken."},
    {kCompareBlocked, "Only where the first one cannot be driven",
     "Planning is several times quicker, and the work takes some percent longer."},
};
constexpr Angle kSameHeading = degrees(0.01);
// A plan that leaves this share of the land, finishing passes and all, is not mended by other corners.
constexpr double kMuchLeft = 0.2;
// Other headings of the search that are driven where the best one blocks.
constexpr std::size_t kMostHeadings = 2;
// Of so few swaths all patterns are driven: where the headland takes most of the time, the order that leads
// best into it and out of it may be any of them.
constexpr std::size_t kFewSwaths = 40;
// Estimated turns may mistake the difference of two orders by a share of the whole time. A plan in another
// order, along another heading, or with another setting, that takes so many times as long as the best one may
// still become the best with corners and an order of its own. Those change more for a heading, and where the
// headland takes nearly all of the time. Of 700 plans with another setting and many swaths, none that took
// 0.5 % longer became the best.
struct Near {
    double byEstimate = 0.04;
    double inOrder = 1.02;
    double inHeading = 1.06;
    double inSetting = 1.06;
};
constexpr Near kNearUsually;
constexpr Near kNearWithHeadland{.inOrder = 1.15, .inHeading = 1.15, .inSetting = 1.15};
constexpr Near kNearWithSwaths{.byEstimate = 0.02, .inSetting = 1.01};
constexpr std::size_t kMostlyHeadland = 8;  // swaths
// Share of the progress of a plan in another order, or along another heading, before its own corners and
// orders.
constexpr double kItself = 0.6;
// An order with its corners, beside a kind of corner.
constexpr double kOrderInCorners = 1.5;

auto problemsOf(const PlannedStages& plan) {
    return problems(plan.driven->findings);
}

bool leavesMuch(const PlannedStages& plan) {
    return !plan.drivable() && plan.driven->audit.left > kMuchLeft * area(plan.request.field->workable());
}

/// Headings that a search by time found, other than the one it took: along the longest edge, which estimates
/// and turns as driven may tell apart otherwise; more of them where the plan cannot be driven.
std::vector<HeadingCandidate> headingsToTry(const PlannedStages& plan) {
    const SwathSet& swaths = plan.laidOut.laid->swaths;
    std::vector<HeadingCandidate> headings;
    if (isBeyondMending(plan.driven->findings)) {
        return headings;
    }
    for (const HeadingCandidate& each : swaths.candidates) {
        const bool isWanted = each.alongLongestEdge || (!plan.drivable() && headings.size() < kMostHeadings);
        if (isWanted && angleBetweenLines(each.heading, swaths.heading) > kSameHeading) {
            headings.push_back(each);
        }
    }
    return headings;
}

Message anotherHeading(const HeadingCandidate& taken, const Message& reason) {
    const Message line = taken.alongLongestEdge ? Message{"Swaths along the longest edge"}
                                                : message("Swaths at a bearing of {:.1f} degrees",
                                                          lineBearingDeg(taken.heading));
    return message("{} are planned instead of the heading with the best estimate: {}", line, reason);
}

void forget(std::vector<SettingChange>& instead, const Parameter& parameter) {
    std::erase_if(instead, [&](const SettingChange& change) { return change.key == parameter.key; });
}

bool isCancelled(const auto& result) {
    return !result && result.error().code == ErrorCode::Cancelled;
}

/// The best plan so far with another in its place. Empty without one.
std::optional<BestSoFar> with(const BestSoFar& best, std::optional<PlannedStages> plan) {
    return std::move(plan).transform([&](PlannedStages&& made) {
        BestSoFar other = best;
        other.plan = std::move(made);
        return other;
    });
}

/// What finishing passes cost in a plan is known from now on.
void learnFinishing(BestSoFar& best, const PlannedStages& plan) {
    if (plan.drivable()) {
        best.finishing.emplace(plannedCorner(plan.request.settings), finishingCost(*plan.driven));
    }
}

const Near& nearOf(const PlannedStages& plan) {
    const std::size_t swaths = plan.ordered->route.steps.size();
    return swaths <= kMostlyHeadland ? kNearWithHeadland
           : swaths <= kFewSwaths    ? kNearUsually
                                     : kNearWithSwaths;
}

/// Without a reverse gear the third kind is the second one.
std::vector<std::string_view> cornerKinds(const Machine& machine) {
    std::vector<std::string_view> kinds{kRoundedCorner, kLoopCorner};
    if (canReverse(machine)) {
        kinds.push_back(kReverseCorner);
    }
    return kinds;
}

/// Whether kinds of corner are left to the planner.
bool comparesCorners(const BestSoFar& best) {
    return best.asked.settings.choice(kHeadlandCorner) == kQuickestCorner &&
           !best.plan.laidOut.headland->drivenPasses.empty();
}

/// Kinds of corner that the plan does not have, and that may be the quickest.
std::vector<std::string_view> otherCorners(const BestSoFar& best) {
    if (!comparesCorners(best)) {
        return {};
    }
    std::vector<std::string_view> kinds = best.nearCorners.value_or(cornerKinds(best.asked.machine));
    std::erase(kinds, plannedCorner(best.plan.request.settings));
    return kinds;
}

}  // namespace

const Parameter kCompare{
    .key = "route.compare",
    .name = "Compare plans",
    .description =
        "Plans with other headings, orders, corners and fewer headland passes are driven beside the first one.",
    .kind = ParameterKind::Choice,
    .standard = 0.0,
    .choices = kComparisons};

bool isCompared(const PlannedStages& asked) {
    return !asked.request.draft &&
           (asked.request.settings.choice(kCompare) == kCompareAlways || !asked.drivable());
}

Duration timeOf(const PlannedStages& plan) {
    return timeForAll(plan.request.machine, plan.driven->path, plan.driven->audit);
}

bool isBetter(const PlannedStages& other, const PlannedStages& plan) {
    return problemsOf(other) != problemsOf(plan) ? problemsOf(other) < problemsOf(plan)
                                                 : timeOf(other) < timeOf(plan);
}

Message reasonFor(const PlannedStages& better, const PlannedStages& other) {
    return problemsOf(better) < problemsOf(other)
               ? Message{"it has fewer problems"}
               : message("it is {} quicker", timeMessage(timeOf(other) - timeOf(better)));
}

bool isTooLargeToCompare(const PlannedStages& plan) {
    return plan.driven->path.segments.size() + plan.request.field->vertexCount() > kMostCompared;
}

void note(std::vector<SettingChange>& instead, const Parameter& parameter, std::string_view value) {
    forget(instead, parameter);
    instead.push_back({std::string{parameter.key}, std::string{value}});
}

bool hasOwnOrder(const Settings& settings) {
    const auto& traits = routeMethod(settings).traits;
    return traits.isByHand || (traits.isByTime && namesSwaths(settings));
}

PlanRequest along(PlanRequest request, Angle heading) {
    request.settings.set(*stageMethod("swaths"), std::string{kFixedHeadingMethod.info.id}).value();
    request.settings.set(kAngle, inDegrees(heading)).value();
    return request;
}

/// So many more plans will be compared.
void PlanChooser::expect(std::size_t plans) {
    const std::scoped_lock lock{mutex_};
    known_ += plans;
}

void PlanChooser::tellCompared() {
    const std::scoped_lock lock{mutex_};
    ++compared_;
    if (course_.compared) {
        course_.compared(compared_, std::max(known_, compared_));
    }
}

/// How another plan is compared with the best one.
struct PlanChooser::Comparison {
    double near = 1.0;  ///< it is wanted if it takes no more than so many times as long
    /// It gets corners and an order of its own if it takes no more than so many times as long.
    double improved = std::numeric_limits<double>::infinity();
    /// Of plans that are made at once, where only those near the best of them are wanted, too.
    QuickestMeanwhile* meanwhile = nullptr;
    /// Of plans with the same headland as the other one.
    const std::map<std::string, FinishingCost>* finishing = nullptr;
};

/// The plan with other settings if it is better as driven, or near. Cancelled.
Result<std::optional<PlannedStages>> PlanChooser::nearPlan(const PlannedStages& best,
                                                           const PlanRequest& other,
                                                           const Comparison& comparison,
                                                           const JobContext& job) {
    const double near = comparison.near;
    QuickestMeanwhile* const meanwhile = comparison.meanwhile;
    const auto* const finishing = comparison.finishing;
    PlanToBeat toBeat = planToBeat(other.machine, *best.driven);
    toBeat.time = near * toBeat.time;
    toBeat.meanwhile = meanwhile;
    toBeat.near = near;
    if (finishing != nullptr) {
        const auto known = finishing->find(plannedCorner(other.settings));
        if (known != finishing->end()) {
            toBeat.finishing = known->second;
            toBeat.finishesAlike = true;
        }
    }
    auto plan = runner_.run(other, toBeat, job);
    if (isCancelled(plan)) {
        return std::unexpected(plan.error());
    }
    tellCompared();
    if (plan && meanwhile != nullptr && plan->drivable()) {
        meanwhile->lower(timeOf(*plan));
    }
    const bool isNear =
        plan && (plan->blockingCount() < best.blockingCount() ||
                 (plan->blockingCount() == best.blockingCount() && timeOf(*plan) <= near * timeOf(best)));
    return isNear ? std::optional{*std::move(plan)} : std::nullopt;
}

/// Takes the best of some plans that are made at once, each from what is the best before. The first of
/// equals.
template <class Make>
Result<void> PlanChooser::takeBest(BestSoFar& best, std::size_t count, const Make& make,
                                   const JobContext& job) {
    expect(count);
    SharedProgress progress{count, job};
    auto made = parallelMap<Result<std::optional<BestSoFar>>>(
        count,
        [&](std::size_t i) {
            auto one = make(i, progress.piece(i));
            progress.finish(i);
            return one;
        },
        job.withoutProgress());
    if (!made) {
        return std::unexpected(made.error());
    }
    for (auto& other : *made) {
        if (!other) {
            return std::unexpected(other.error());
        }
        if (*other && isBetter((*other)->plan, best.plan)) {
            best = **std::move(other);
        }
    }
    return {};
}

/// The kinds that the plan does not have. Those that reach into corners are worth it where the plan can be
/// driven.
Result<void> PlanChooser::tryCorners(BestSoFar& best, const JobContext& job) {
    if (!comparesCorners(best)) {
        return {};
    }
    const std::string taken = plannedCorner(best.plan.request.settings);
    note(best.instead, kHeadlandCorner, taken);
    if (lastingCount(best.plan.driven->findings) > 0 || leavesMuch(best.plan) ||
        isTooLargeToCompare(best.plan)) {
        return {};
    }
    const bool isFirst = !best.nearCorners;
    const double near = isFirst ? nearOf(best.plan).inOrder : 1.0;
    const std::vector<std::string_view> others = otherCorners(best);
    const std::optional<PlannedStages> before = best.plan;
    std::vector<std::optional<PlannedStages>> plans(others.size());
    QuickestMeanwhile meanwhile;
    const auto withCorner = [&](std::size_t i, const JobContext& piece) -> Result<std::optional<BestSoFar>> {
        PlanRequest request = best.plan.request;
        request.settings.set(kHeadlandCorner, std::string{others[i]}).value();
        auto plan = nearPlan(best.plan, request,
                             {.near = near, .meanwhile = &meanwhile, .finishing = &best.finishing}, piece);
        return std::move(plan).transform([&](std::optional<PlannedStages>&& made) {
            plans[i] = made;
            return with(best, std::move(made)).transform([&](BestSoFar&& other) {
                note(other.instead, kHeadlandCorner, others[i]);
                return std::move(other);
            });
        });
    };
    auto tried = takeBest(best, others.size(), withCorner, job);
    // What blocks here, and is quicker, may be drivable along another heading; where all of them block, each
    // may.
    if (isFirst && best.plan.drivable()) {
        const Duration most = near * timeOf(best.plan);
        best.nearCorners.emplace();
        for (const std::string_view kind : cornerKinds(best.asked.machine)) {
            const auto other = std::ranges::find(others, kind);
            const auto& plan =
                other == others.end() ? before : plans[static_cast<std::size_t>(other - others.begin())];
            if (plan && timeOf(*plan) <= most) {
                best.nearCorners->push_back(kind);
                learnFinishing(best, *plan);
            }
        }
    }
    return tried;
}

/// Orders that the route by estimated turns passed over, and that are about as quick by its estimate.
Result<std::vector<std::string_view>> patternsToTry(const PlannedStages& plan, const JobContext& job) {
    std::vector<std::string_view> ids;
    if (!routeMethod(plan.request.settings).traits.isByTime || !plan.drivable() ||
        isTooLargeToCompare(plan) || routeObjective(plan.request.settings) != RouteObjective::Time ||
        hasOwnOrder(plan.request.settings) || plan.request.settings.count(kOpenStrips) ||
        plan.ordered->route.steps.empty()) {
        return ids;
    }
    const Route& taken = plan.ordered->route;
    const RouteTask task = routeTask(plan.request, plan.laidOut.laid->swaths, plan.ordered->cells);
    const RouteCosts costs{task};
    const double nearS =
        costs.links().of(endOrder(taken.steps)) + nearOf(plan).byEstimate * plan.driven->path.duration().si();
    // Of few swaths several patterns are the same order.
    std::vector<Route> known{taken};
    for (const Method<RoutePlanner>* const pattern : routePatterns()) {
        if (!pattern->traits.isPlain && taken.steps.size() > kFewSwaths) {
            continue;
        }
        auto route = pattern->run(task, job);
        if (!route) {
            return std::unexpected(route.error());
        }
        if (!std::ranges::contains(known, *route) && costs.links().of(endOrder(route->steps)) <= nearS) {
            ids.push_back(pattern->info.id);
            known.push_back(*std::move(route));
        }
    }
    return ids;
}

/// Order and corners for the swaths of this plan. An order of one's own stays. Cancelled.
/// @param rival  the best plan along other headings: what is no better is not wanted
Result<void> PlanChooser::decideOrderAndCorners(BestSoFar& best, const PlannedStages* rival,
                                                const JobContext& job) {
    const auto patterns = patternsToTry(best.plan, job.withoutProgress());
    if (!patterns) {
        return std::unexpected(patterns.error());
    }
    const auto corners = static_cast<double>(cornerKinds(best.asked.machine).size() - 1);
    const double share = corners / (corners + kOrderInCorners * static_cast<double>(patterns->size()));
    return tryCorners(best, job.part(0.0, share)).and_then([&] {
        QuickestMeanwhile meanwhile;
        return takeBest(
            best, patterns->size(),
            [&](std::size_t i, const JobContext& piece) {
                return inOrder(best, rival, (*patterns)[i], meanwhile, piece);
            },
            job.part(share, 1.0));
    });
}

/// The plan in another order with its own best corners, if it is near. Cancelled.
/// @param meanwhile  of orders that are made at once
Result<std::optional<BestSoFar>> PlanChooser::inOrder(const BestSoFar& best, const PlannedStages* rival,
                                                      std::string_view pattern, QuickestMeanwhile& meanwhile,
                                                      const JobContext& job) {
    const Parameter& route = *stageMethod("route");
    PlanRequest request = best.plan.request;
    request.settings.set(route, std::string{pattern}).value();
    // An order that gets other corners may be slower before.
    const bool hasItsCorners = otherCorners(best).empty();
    const bool isBehind = rival != nullptr && isBetter(*rival, best.plan);
    auto plan = nearPlan(isBehind ? *rival : best.plan, request,
                         {.near = hasItsCorners ? 1.0 : nearOf(best.plan).inOrder,
                          .meanwhile = hasItsCorners ? &meanwhile : nullptr,
                          .finishing = &best.finishing},
                         job.part(0.0, kItself));
    if (!plan || !*plan) {
        return plan.transform([](auto&&) { return std::optional<BestSoFar>{}; });
    }
    BestSoFar other = *with(best, *std::move(plan));
    note(other.instead, route, pattern);
    return tryCorners(other, job.part(kItself, 1.0)).transform([&] {
        return std::optional{std::move(other)};
    });
}

Result<std::optional<BestSoFar>> PlanChooser::changed(const BestSoFar& best, const PlanRequest& asked,
                                                      const JobContext& job) {
    const Near& near = nearOf(best.plan);
    return changed(best, asked, {.near = near.inHeading, .improved = near.inSetting}, nullptr, job);
}

Result<std::optional<BestSoFar>> PlanChooser::changed(const BestSoFar& best, const PlanRequest& asked,
                                                      const Comparison& comparison,
                                                      const PlannedStages* rival, const JobContext& job) {
    PlanRequest request = asked;
    const std::string corner = best.plan.request.settings.choice(kHeadlandCorner);
    const bool isByTime = asked.settings.choice(kHeadlandCorner) == kQuickestCorner;
    if (isByTime) {
        request.settings.set(kHeadlandCorner, corner).value();
    }
    auto plan = nearPlan(best.plan, request, comparison, job.part(0.0, kItself));
    if (plan && !*plan && isByTime && plannedCorner(best.plan.request.settings) != kRoundedCorner) {
        // Corners that are driven into may block with this change.
        request.settings.set(kHeadlandCorner, std::string{kRoundedCorner}).value();
        expect(1);
        plan = nearPlan(best.plan, request, comparison, job.withoutProgress());
    }
    if (!plan || !*plan) {
        return plan.transform([](auto&&) { return std::optional<BestSoFar>{}; });
    }
    BestSoFar other = *with(best, *std::move(plan));
    other.asked = asked;
    if (other.plan.driven == best.plan.driven) {
        // The same plan, whose order and corners are decided.
        return std::optional{std::move(other)};
    }
    forget(other.instead, *stageMethod("route"));
    if (other.plan.laidOut.headland->mainland != best.plan.laidOut.headland->mainland) {
        other.nearCorners.reset();
        other.finishing.clear();
    }
    learnFinishing(other, other.plan);
    if (other.plan.blockingCount() == best.plan.blockingCount() &&
        timeOf(other.plan) > comparison.improved * timeOf(best.plan)) {
        return std::optional{std::move(other)};
    }
    return decideOrderAndCorners(other, rival, job.part(kItself, 1.0)).transform([&] {
        return std::optional{std::move(other)};
    });
}

/// The plan along another heading with its own best order and corners, if it is near. Cancelled.
Result<std::optional<BestSoFar>> PlanChooser::alongHeading(const BestSoFar& best,
                                                           const HeadingCandidate& candidate,
                                                           const JobContext& job) {
    // Along this heading nothing is wanted that is no better.
    const Comparison comparison{.near = nearOf(best.plan).inHeading, .finishing = &best.finishing};
    auto other = changed(best, along(best.asked, candidate.heading), comparison, &best.plan, job);
    if (other && *other) {
        (*other)->asked = best.asked;
        if (isBetter((*other)->plan, best.plan)) {
            (*other)->notes = {
                {anotherHeading(candidate, reasonFor((*other)->plan, best.plan)), "instead", {}}};
        }
    }
    return other;
}

Result<BestSoFar> PlanChooser::improved(const PlanRequest& request, const JobContext& job) {
    const bool comparesAlways = request.settings.choice(kCompare) == kCompareAlways;
    const double begun = request.draft ? 1.0 : comparesAlways ? kAskedShare : kAskedAloneShare;
    auto asked = runner_.run(request, {}, job.part(0.0, begun));
    if (!asked) {
        return std::unexpected(asked.error());
    }
    BestSoFar best{.asked = request, .plan = *asked, .headings = asked->laidOut.laid->swaths.candidates};
    if (request.draft) {
        return best;
    }
    if (course_.asked) {
        course_.asked(*asked);
    }
    if (!isCompared(*asked)) {
        return best;
    }
    learnFinishing(best, *asked);
    const bool isTooLarge = isTooLargeToCompare(*asked);
    if (isTooLarge) {
        best.notes.push_back(
            {message("headings, orders and corners are not compared as driven: the path has {} parts and the "
                     "field {} corners, and with more than {} in all that takes too long",
                     asked->driven->path.segments.size(), request.field->vertexCount(), kMostCompared),
             "instead",
             {}});
    }
    const bool triesHeadings =
        !isTooLarge && !hasOwnOrder(request.settings) && !hasHeadingPerCell(request.settings);
    const std::vector<HeadingCandidate> headings =
        triesHeadings ? headingsToTry(*asked) : std::vector<HeadingCandidate>{};
    const double decided = begun + (1.0 - begun) / (1.0 + static_cast<double>(headings.size()));
    return decideOrderAndCorners(best, nullptr, job.part(begun, decided))
        .and_then([&] {
            return takeBest(
                best, headings.size(),
                [&](std::size_t i, const JobContext& piece) {
                    return alongHeading(best, headings[i], piece);
                },
                job.part(decided, 1.0));
        })
        .transform([&] { return std::move(best); });
}

}  // namespace furrow
