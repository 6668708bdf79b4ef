#include "planner/plan/quicker_choice.h"

#include "planner/decomposition/decomposition.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/jobs/parallel.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/order_stage.h"
#include "planner/route/methods.h"
#include "planner/route/patterns.h"
#include "planner/route/route_costs.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace furrow {

namespace {

/// A setting and the simpler choice for it.
struct SimplerChoice {
    std::string_view key;
    std::string_view chosen;
    std::string_view simpler;
};

constexpr SimplerChoice kSimplerChoices[] = {
    {"headland.method", "per-edge", "constant"},
    {"decomposition.heading", "per-cell", "common"},
};

constexpr Angle kSameHeading = degrees(0.01);
// Other headings of the search that are driven where the best one blocks.
constexpr std::size_t kMostHeadings = 2;
// Estimated turns may mistake the difference of two orders by this share of the whole time.
constexpr double kNearPattern = 0.04;
// A plan in another order, or along another heading, that takes this many times as long as the best one may
// still become the best with corners and an order of its own. Those of a heading change more.
constexpr double kNearInOrder = 1.02;
constexpr double kNearInHeading = 1.06;
// With this share of the field as mainland, another number of headland passes saves little.
constexpr double kMuchMainland = 0.7;
constexpr int kTwoPasses = 2;

std::string_view choiceName(const Parameter& parameter, std::string_view id) {
    return std::ranges::find(parameter.choices, id, &Choice::id)->name;
}

Duration timeOf(const PlannedStages& plan) {
    return timeForAll(plan.request.machine, plan.driven->path, plan.driven->audit);
}

auto problemsOf(const PlannedStages& plan) {
    return problems(plan.driven->findings);
}

bool isBetter(const PlannedStages& other, const PlannedStages& plan) {
    return problemsOf(other) != problemsOf(plan) ? problemsOf(other) < problemsOf(plan)
                                                 : timeOf(other) < timeOf(plan);
}

/// Why a plan is better than another.
Message reasonFor(const PlannedStages& better, const PlannedStages& other) {
    return problemsOf(better) < problemsOf(other)
               ? Message{"it has fewer problems"}
               : message("it is {:.0f} s quicker", (timeOf(other) - timeOf(better)).si());
}

Message takenInstead(const Parameter& parameter, const SimplerChoice& choice, const Message& reason) {
    return message("\"{}\": \"{}\" is planned instead of \"{}\": {}", parameter.name,
                   choiceName(parameter, choice.simpler), choiceName(parameter, choice.chosen), reason);
}

PlanRequest along(PlanRequest request, Angle heading) {
    request.settings.set(*stageMethod("swaths"), std::string{kFixedHeadingMethod.info.id}).value();
    request.settings.set(kAngle, inDegrees(heading)).value();
    return request;
}

/// Headings that a search by time found, other than the one it took: along the longest edge, which estimates
/// and turns as driven may tell apart otherwise; more of them where the plan cannot be driven.
std::vector<HeadingCandidate> headingsToTry(const PlannedStages& plan) {
    const SwathSet& swaths = plan.laidOut.laid->swaths;
    std::vector<HeadingCandidate> headings;
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

Message fewerPasses(int passes, const Message& reason) {
    return message("A headland of {} is planned instead of one that is wide enough for turns: {}",
                   counted("{} pass", "{} passes", passes), reason);
}

void forget(std::vector<SettingChange>& instead, const Parameter& parameter) {
    std::erase_if(instead, [&](const SettingChange& change) { return change.key == parameter.key; });
}

/// The value that was used for a setting; another one may have been noted before.
void note(std::vector<SettingChange>& instead, const Parameter& parameter, std::string_view value) {
    forget(instead, parameter);
    instead.push_back({std::string{parameter.key}, std::string{value}});
}

bool isCancelled(const auto& result) {
    return !result && result.error().code == ErrorCode::Cancelled;
}

/// An order of one's own names the swaths of just these choices.
bool hasOwnOrder(const Settings& settings) {
    const auto& traits = routeMethod(settings).traits;
    return traits.isByHand || (traits.isByTime && !settings.numbers(kLocked).empty());
}

/// The best plan so far.
struct Best {
    PlanRequest asked;                            ///< before anything was decided
    PlannedStages plan;                           ///< whose request has all that was decided
    std::vector<HeadingCandidate> headings = {};  ///< of the search
    std::vector<SettingChange> instead = {};
    std::vector<Note> notes = {};
    /// Kinds of corner that may be the quickest with this headland: all until they are compared, then those
    /// that came near. Another order or heading hardly changes what a corner costs.
    std::optional<std::vector<std::string_view>> nearCorners = {};
};

/// The best plan so far with another in its place. Empty without one.
std::optional<Best> with(const Best& best, std::optional<PlannedStages> plan) {
    return std::move(plan).transform([&](PlannedStages&& made) {
        Best other = best;
        other.plan = std::move(made);
        return other;
    });
}

/// Without a reverse gear the third kind is the second one.
std::vector<std::string_view> cornerKinds(const Machine& machine) {
    std::vector<std::string_view> kinds{kRoundedCorner, kLoopCorner};
    if (canReverse(machine)) {
        kinds.push_back(kReverseCorner);
    }
    return kinds;
}

/// Whether two passes of headland take much of the field, or leave the plan blocked, or one takes all of it.
/// More than two are needed for turns: fewer of them save no time.
bool mayHaveFewerPasses(const PlannedStages& plan) {
    const Headland& headland = *plan.laidOut.headland;
    return headland.isPerimeterOnly ||
           (headland.passes == kTwoPasses && (!plan.drivable() || headland.mainlandRatio < kMuchMainland));
}

/// Compares plans by their stages.
class Chooser {
public:
    Chooser(StageRunner& runner, const JobContext& job) : runner_{runner}, quiet_{job.withoutProgress()} {}

    /// The plan as asked, with what is left to the planner decided by the time of the driven path. Cancelled.
    Result<Best> improved(const PlanRequest& request, const JobContext& job);

    /// Takes the plan with the simpler choice where that is quicker, each as good as it gets. Cancelled.
    Result<void> trySimpler(Best& best, const SimplerChoice& choice);

    /// Takes the plan with fewer headland passes where that is quicker, each as good as it gets. Cancelled.
    Result<void> tryFewerPasses(Best& best);

private:
    template <class Make>
    Result<void> takeBest(Best& best, std::size_t count, const Make& make);
    Result<std::optional<PlannedStages>> nearPlan(const Best& best, const PlanRequest& other, double near,
                                                  QuickestMeanwhile* meanwhile = nullptr);
    Result<void> tryCorners(Best& best);
    Result<void> decideOrderAndCorners(Best& best);
    Result<std::optional<Best>> inOrder(const Best& best, std::string_view pattern);
    Result<std::optional<Best>> alongHeading(const Best& best, const HeadingCandidate& candidate);

    StageRunner& runner_;
    JobContext quiet_;
};

/// The plan with other settings if it is better as driven, or takes less than `near` times as long.
/// Cancelled.
/// @param meanwhile  of plans that are made at once, where only the best is wanted
Result<std::optional<PlannedStages>> Chooser::nearPlan(const Best& best, const PlanRequest& other,
                                                       double near, QuickestMeanwhile* meanwhile) {
    PlanToBeat toBeat = planToBeat(other.machine, *best.plan.driven);
    toBeat.time = near * toBeat.time;
    toBeat.meanwhile = meanwhile;
    auto plan = runner_.run(other, toBeat, quiet_);
    if (isCancelled(plan)) {
        return std::unexpected(plan.error());
    }
    if (plan && meanwhile != nullptr && plan->drivable()) {
        meanwhile->lower(timeOf(*plan));
    }
    const bool isNear =
        plan &&
        (plan->blockingCount() < best.plan.blockingCount() ||
         (plan->blockingCount() == best.plan.blockingCount() && timeOf(*plan) <= near * timeOf(best.plan)));
    return isNear ? std::optional{*std::move(plan)} : std::nullopt;
}

/// Takes the best of some plans that are made at once, each from what is the best before. The first of
/// equals.
template <class Make>
Result<void> Chooser::takeBest(Best& best, std::size_t count, const Make& make) {
    auto made = parallelMap<Result<std::optional<Best>>>(count, make, quiet_);
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
Result<void> Chooser::tryCorners(Best& best) {
    if (best.asked.settings.choice(kHeadlandCorner) != kQuickestCorner ||
        best.plan.laidOut.headland->drivenPasses.empty()) {
        return {};
    }
    std::string taken = best.plan.request.settings.choice(kHeadlandCorner);
    taken = taken == kQuickestCorner ? std::string{kRoundedCorner} : taken;
    note(best.instead, kHeadlandCorner, taken);
    if (lastingCount(best.plan.driven->findings) > 0) {
        return {};
    }
    const bool isFirst = !best.nearCorners;
    std::vector<std::string_view> kinds = best.nearCorners.value_or(cornerKinds(best.asked.machine));
    std::vector<char> isNear(kinds.size(), 1);
    QuickestMeanwhile meanwhile;
    auto tried = takeBest(best, kinds.size(), [&](std::size_t i) -> Result<std::optional<Best>> {
        if (kinds[i] == taken) {
            return std::optional<Best>{};
        }
        PlanRequest request = best.plan.request;
        request.settings.set(kHeadlandCorner, std::string{kinds[i]}).value();
        auto plan =
            isFirst ? nearPlan(best, request, kNearInOrder) : nearPlan(best, request, 1.0, &meanwhile);
        return std::move(plan).transform([&](std::optional<PlannedStages>&& made) {
            isNear[i] = made ? 1 : 0;
            return with(best, std::move(made)).transform([&](Best&& other) {
                note(other.instead, kHeadlandCorner, kinds[i]);
                return std::move(other);
            });
        });
    });
    if (isFirst) {
        std::vector<std::string_view> near;
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (isNear[i] != 0) {
                near.push_back(kinds[i]);
            }
        }
        best.nearCorners = std::move(near);
    }
    return tried;
}

/// Orders that the route by estimated turns passed over, and that are about as quick by its estimate.
Result<std::vector<std::string_view>> patternsToTry(const PlannedStages& plan, const JobContext& job) {
    std::vector<std::string_view> ids;
    if (!routeMethod(plan.request.settings).traits.isByTime || !plan.drivable() ||
        routeObjective(plan.request.settings) != RouteObjective::Time || hasOwnOrder(plan.request.settings) ||
        plan.ordered->route.steps.empty()) {
        return ids;
    }
    const Route& taken = plan.ordered->route;
    const RouteTask task = routeTask(plan.request, plan.laidOut.laid->swaths, plan.ordered->cells);
    const RouteCosts costs{task};
    const double nearS =
        costs.links().of(endOrder(taken.steps)) + kNearPattern * plan.driven->path.duration().si();
    for (const Method<RoutePlanner>* const pattern : plainPatterns()) {
        const auto route = pattern->run(task, job);
        if (!route) {
            return std::unexpected(route.error());
        }
        if (*route != taken && costs.links().of(endOrder(route->steps)) <= nearS) {
            ids.push_back(pattern->info.id);
        }
    }
    return ids;
}

/// Order and corners for the swaths of this plan. An order of one's own stays. Cancelled.
Result<void> Chooser::decideOrderAndCorners(Best& best) {
    const auto patterns = patternsToTry(best.plan, quiet_);
    if (!patterns) {
        return std::unexpected(patterns.error());
    }
    return tryCorners(best).and_then([&] {
        return takeBest(best, patterns->size(), [&](std::size_t i) { return inOrder(best, (*patterns)[i]); });
    });
}

/// The plan in another order with its own best corners, if it is near. Cancelled.
Result<std::optional<Best>> Chooser::inOrder(const Best& best, std::string_view pattern) {
    const Parameter& route = *stageMethod("route");
    PlanRequest request = best.plan.request;
    request.settings.set(route, std::string{pattern}).value();
    auto plan = nearPlan(best, request, kNearInOrder);
    if (!plan || !*plan) {
        return plan.transform([](auto&&) { return std::optional<Best>{}; });
    }
    Best other = *with(best, *std::move(plan));
    note(other.instead, route, pattern);
    return tryCorners(other).transform([&] { return std::optional{std::move(other)}; });
}

/// The plan along another heading with its own best order and corners, if it is near. It is first planned
/// with the corners of the best plan so far. Cancelled.
Result<std::optional<Best>> Chooser::alongHeading(const Best& best, const HeadingCandidate& candidate) {
    PlanRequest request = along(best.asked, candidate.heading);
    const std::string corner = best.plan.request.settings.choice(kHeadlandCorner);
    request.settings.set(kHeadlandCorner, corner).value();
    auto plan = nearPlan(best, request, kNearInHeading);
    const bool isByTime = best.asked.settings.choice(kHeadlandCorner) == kQuickestCorner;
    if (plan && !*plan && isByTime && corner != kRoundedCorner) {
        // Corners that are driven into may block along this heading.
        request.settings.set(kHeadlandCorner, std::string{kRoundedCorner}).value();
        plan = nearPlan(best, request, kNearInHeading);
    }
    if (!plan || !*plan) {
        return plan.transform([](auto&&) { return std::optional<Best>{}; });
    }
    Best other = *with(best, *std::move(plan));
    forget(other.instead, *stageMethod("route"));
    return decideOrderAndCorners(other).transform([&] {
        if (isBetter(other.plan, best.plan)) {
            other.notes = {{anotherHeading(candidate, reasonFor(other.plan, best.plan)), "instead", {}}};
        }
        return std::optional{std::move(other)};
    });
}

Result<Best> Chooser::improved(const PlanRequest& request, const JobContext& job) {
    auto asked = runner_.run(request, {}, job);
    if (!asked) {
        return std::unexpected(asked.error());
    }
    Best best{.asked = request, .plan = *asked, .headings = asked->laidOut.laid->swaths.candidates};
    if (request.draft) {
        return best;
    }
    Result<void> tried = decideOrderAndCorners(best);
    const bool hasOneHeading = !hasHeadingPerCell(request.settings);
    if (!hasOwnOrder(request.settings) && hasOneHeading) {
        const std::vector<HeadingCandidate> headings = headingsToTry(*asked);
        tried = tried.and_then([&] {
            return takeBest(best, headings.size(),
                            [&](std::size_t i) { return alongHeading(best, headings[i]); });
        });
    }
    return tried.transform([&] { return std::move(best); });
}

Result<void> Chooser::tryFewerPasses(Best& best) {
    const Settings& asked = best.asked.settings;
    if (!headlandMethod(asked).traits.isOneWidth || asked.isSet(kHeadlandWidth) ||
        asked.isSet(kHeadlandPasses)) {
        return {};
    }
    while (mayHaveFewerPasses(best.plan)) {
        const int passes = best.plan.laidOut.headland->passes - 1;
        Best other = best;
        other.nearCorners.reset();
        other.asked.settings.set(kHeadlandPasses, static_cast<double>(passes)).value();
        PlanRequest request = other.asked;
        request.settings.set(kHeadlandCorner, best.plan.request.settings.choice(kHeadlandCorner)).value();
        auto plan = nearPlan(best, request, kNearInHeading);
        if (!plan || !*plan) {
            return plan.transform([](auto&&) {});
        }
        other.plan = **std::move(plan);
        forget(other.instead, *stageMethod("route"));
        if (auto decided = decideOrderAndCorners(other); !decided) {
            return decided;
        }
        if (!isBetter(other.plan, best.plan)) {
            return {};
        }
        other.headings = other.plan.laidOut.laid->swaths.candidates;
        other.notes = {{fewerPasses(passes, reasonFor(other.plan, best.plan)), "instead", {}}};
        note(other.instead, kHeadlandPasses, std::to_string(passes));
        best = std::move(other);
    }
    return {};
}

Result<void> Chooser::trySimpler(Best& best, const SimplerChoice& choice) {
    const Parameter& parameter = **findParameter(choice.key);
    if (best.asked.settings.choice(parameter) != choice.chosen) {
        return {};
    }
    PlanRequest simpler = best.asked;
    if (auto set = simpler.settings.setText(parameter, choice.simpler); !set) {
        return set;
    }
    auto other = improved(simpler, quiet_);
    if (!other) {
        return isCancelled(other) ? Result<void>{std::unexpected(other.error())} : Result<void>{};
    }
    if (!isBetter(other->plan, best.plan)) {
        return {};
    }
    other->notes.push_back(
        {takenInstead(parameter, choice, reasonFor(other->plan, best.plan)), "instead", {}});
    other->instead.push_back({std::string{choice.key}, std::string{choice.simpler}});
    std::ranges::copy_if(best.instead, std::back_inserter(other->instead), [](const SettingChange& change) {
        return std::ranges::contains(kSimplerChoices, change.key, &SimplerChoice::key);
    });
    best = *std::move(other);
    return {};
}

}  // namespace

Result<QuickestChoice> quickestChoice(const PlanRequest& request, StageRunner& runner,
                                      const JobContext& job) {
    Chooser chooser{runner, job};
    auto best = chooser.improved(request, job);
    if (!best) {
        return std::unexpected(best.error());
    }
    Result<void> tried;
    if (!request.draft && !hasOwnOrder(request.settings)) {
        tried = chooser.tryFewerPasses(*best);
        for (const SimplerChoice& choice : kSimplerChoices) {
            tried = tried.and_then([&] { return chooser.trySimpler(*best, choice); });
        }
    }
    return tried.transform([&] {
        return QuickestChoice{std::move(best->plan), std::move(best->instead), std::move(best->notes),
                              std::move(best->headings)};
    });
}

}  // namespace furrow
