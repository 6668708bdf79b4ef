#include "planner/plan/quicker_choice.h"

#include "planner/decomposition/decomposition.h"
#include "planner/headland/headland_passes.h"
#include "planner/plan/as_asked.h"
#include "planner/plan/method_registry.h"
#include "planner/route/methods.h"
#include "planner/route/patterns.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
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
// With a path that is slower by more than this, order and corners do not make a heading the quickest.
constexpr double kNearTime = 1.03;
// Other headings of the search that are driven where the best one blocks.
constexpr std::size_t kMostHeadings = 2;
// Patterns that every driver knows, and that have the fewest long ways.
constexpr std::array kPlainPatterns{&kBoustrophedonMethod, &kSnakeMethod};
// Free-space turns are too short by this share of the path at most, seen over real fields.
constexpr double kNearPattern = 0.1;

std::string_view choiceName(const Parameter& parameter, std::string_view id) {
    return std::ranges::find(parameter.choices, id, &Choice::id)->name;
}

bool isBetter(const Plan& other, const Plan& plan) {
    if (other.blockingCount() != plan.blockingCount()) {
        return other.blockingCount() < plan.blockingCount();
    }
    return timeForAll(other) < timeForAll(plan);
}

/// Why a plan is better than another.
Message reasonFor(const Plan& better, const Plan& other) {
    return better.blockingCount() < other.blockingCount()
               ? Message{"less stands in its way"}
               : message("it is {:.0f} s quicker", (timeForAll(other) - timeForAll(better)).si());
}

Message takenInstead(const Parameter& parameter, const SimplerChoice& choice, const Message& reason) {
    return message("\"{}\": \"{}\" is planned instead of \"{}\": {}", parameter.name, choiceName(parameter, choice.simpler),
                   choiceName(parameter, choice.chosen), reason);
}

PlanRequest along(PlanRequest request, Angle heading) {
    request.settings.set(*stageMethod("swaths"), std::string{kFixedHeadingMethod.info.id}).value();
    request.settings.set(kAngle, inDegrees(heading)).value();
    return request;
}

/// Headings that a search by time found, other than the one it took: along the longest edge, which estimates and turns as
/// driven may tell apart otherwise; more of them where the plan cannot be driven.
std::vector<HeadingCandidate> headingsToTry(const Plan& plan) {
    std::vector<HeadingCandidate> headings;
    for (const HeadingCandidate& each : plan.swaths.candidates) {
        const bool isWanted = each.alongLongestEdge || (!plan.drivable() && headings.size() < kMostHeadings);
        if (isWanted && angleBetweenLines(each.heading, plan.swaths.heading) > kSameHeading) {
            headings.push_back(each);
        }
    }
    return headings;
}

Message anotherHeading(const HeadingCandidate& taken, const Message& reason) {
    const Message line = taken.alongLongestEdge ? Message{"Swaths along the longest edge"}
                                                : message("Swaths at a bearing of {:.1f} degrees", lineBearingDeg(taken.heading));
    return message("{} are planned instead of the heading with the best estimate: {}", line, reason);
}

/// The best plan so far, and the settings that it was made with.
struct Best {
    PlanRequest asked;    ///< before anything was decided
    PlanRequest request;  ///< as the plan has it
    std::shared_ptr<Plan> plan;
    std::vector<SettingChange> instead;
    std::vector<Note> notes;
};

/// Takes the plan with other settings where it is better as driven: whether it did. One that cannot be made is no better.
/// Cancelled.
Result<bool> takeIfBetter(Best& best, PlanRequest other, const JobContext& job) {
    auto plan = planAsAsked(other, job.quiet(), best.plan->drivable() ? std::optional{timeForAll(*best.plan)} : std::nullopt);
    if (!plan && plan.error().code == ErrorCode::Cancelled) {
        return std::unexpected(plan.error());
    }
    if (!plan || !isBetter(**plan, *best.plan)) {
        return false;
    }
    best.plan = std::move(*plan);
    best.request = std::move(other);
    return true;
}

/// Patterns that the route by estimated turns passed over.
Result<void> tryPatterns(Best& best, const JobContext& job) {
    if (routeMethod(best.request.settings) != kOptimisedMethod.run || !best.plan->drivable()) {
        return {};
    }
    const Best searched = best;
    const RouteTask task = routeTask(*searched.plan);
    const Duration estimate = turningTime(searched.plan->route.steps, task);
    const Duration near = estimate + kNearPattern * searched.plan->path.duration();
    for (const Method<RoutePlanner>* const pattern : kPlainPatterns) {
        const auto route = pattern->run(task, job.quiet());
        if (!route) {
            return std::unexpected(route.error());
        }
        if (*route == searched.plan->route || turningTime(route->steps, task) > near) {
            continue;
        }
        PlanRequest request = searched.plan->swaths.candidates.empty() ? searched.request
                                                                       : along(searched.request, searched.plan->swaths.heading);
        request.settings.set(*stageMethod("route"), std::string{pattern->info.id}).value();
        const auto taken = takeIfBetter(best, std::move(request), job);
        if (!taken) {
            return std::unexpected(taken.error());
        }
        if (*taken) {
            best.instead = searched.instead;
            best.instead.push_back({std::string{stageMethod("route")->key}, std::string{pattern->info.id}});
        }
    }
    return {};
}

/// Those that reach into corners are worth it where the plan can be driven.
Result<void> tryCorners(Best& best, const JobContext& job) {
    if (best.request.settings.choice(kHeadlandCorner) != kQuickestCorner || best.plan->headland.rings.empty()) {
        return {};
    }
    std::string_view corner = kRoundedCorner;
    for (const std::string_view other : {kLoopCorner, kReverseCorner}) {
        if (!best.plan->drivable()) {
            break;
        }
        PlanRequest request = best.request;
        request.settings.set(kHeadlandCorner, std::string{other}).value();
        const auto taken = takeIfBetter(best, std::move(request), job);
        if (!taken) {
            return std::unexpected(taken.error());
        }
        corner = *taken ? other : corner;
    }
    best.instead.push_back({std::string{kHeadlandCorner.key}, std::string{corner}});
    return {};
}

/// An order of one's own names the swaths of just these choices.
bool hasOwnOrder(const Settings& settings) {
    return routeMethod(settings) == kCustomMethod.run;
}

/// Order and corners, for the swaths of this plan. Cancelled.
Result<void> decideOrderAndCorners(Best& best, const JobContext& job) {
    return tryPatterns(best, job).and_then([&] { return tryCorners(best, job); });
}

/// Takes the plan along another heading, with its own order and corners, where that is quicker. Cancelled.
Result<void> tryHeading(Best& best, const PlanRequest& asked, const HeadingCandidate& candidate, std::optional<Duration> atMost,
                        const JobContext& job) {
    const PlanRequest request = along(asked, candidate.heading);
    auto plan = planAsAsked(request, job.quiet(), atMost);
    if (!plan) {
        return plan.error().code == ErrorCode::Cancelled ? Result<void>{std::unexpected(plan.error())} : Result<void>{};
    }
    Best other{.asked = asked, .request = request, .plan = *std::move(plan), .instead = {}, .notes = {}};
    if (auto decided = decideOrderAndCorners(other, job); !decided) {
        return decided;
    }
    if (isBetter(*other.plan, *best.plan)) {
        other.notes.push_back({anotherHeading(candidate, reasonFor(*other.plan, *best.plan)), "instead", {}});
        best = std::move(other);
    }
    return {};
}

/// The plan as asked, with what is left to the planner decided by the time of the driven path. Cancelled.
Result<Best> improved(const PlanRequest& request, const JobContext& job) {
    auto asked = planAsAsked(request, job);
    if (!asked) {
        return std::unexpected(asked.error());
    }
    Best best{.asked = request, .request = request, .plan = *asked, .instead = {}, .notes = {}};
    if (request.draft) {
        return best;
    }
    const Plan& plain = **asked;
    Result<void> tried;
    if (!hasOwnOrder(request.settings)) {
        tried = decideOrderAndCorners(best, job);
    } else {
        tried = tryCorners(best, job);
    }
    if (!hasOwnOrder(request.settings) && request.settings.choice(kCellHeading) != "per-cell") {
        const auto atMost = plain.drivable() ? std::optional{kNearTime * timeForAll(plain)} : std::nullopt;
        for (const HeadingCandidate& candidate : headingsToTry(plain)) {
            tried = tried.and_then([&] { return tryHeading(best, request, candidate, atMost, job); });
        }
    }
    if (!tried) {
        return std::unexpected(tried.error());
    }
    best.plan->swaths.candidates = plain.swaths.candidates;
    return best;
}

/// Takes the plan with the simpler choice where that is quicker, each as good as it gets. Cancelled.
Result<void> trySimpler(Best& best, const SimplerChoice& choice, const JobContext& job) {
    const Parameter& parameter = **findParameter(choice.key);
    if (best.asked.settings.choice(parameter) != choice.chosen) {
        return {};
    }
    PlanRequest simpler = best.asked;
    if (auto set = simpler.settings.setText(parameter, choice.simpler); !set) {
        return set;
    }
    auto other = improved(simpler, job.quiet());
    if (!other && other.error().code == ErrorCode::Cancelled) {
        return std::unexpected(other.error());
    }
    if (!other || !isBetter(*other->plan, *best.plan)) {
        return {};
    }
    other->notes.push_back({takenInstead(parameter, choice, reasonFor(*other->plan, *best.plan)), "instead", {}});
    other->instead.push_back({std::string{choice.key}, std::string{choice.simpler}});
    std::ranges::copy_if(best.instead, std::back_inserter(other->instead), [](const SettingChange& change) {
        return std::ranges::contains(kSimplerChoices, change.key, &SimplerChoice::key);
    });
    best = std::move(*other);
    return {};
}

}  // namespace

Duration timeForAll(const Plan& plan) {
    const Machine& machine = plan.request.machine;
    const double missedM = plan.audit.missed.value_or(Area{}).si() / machine.operatingWidth().si();
    return plan.path.duration() + seconds(missedM / machine.spec().tractor.workingSpeed.si());
}

Result<std::shared_ptr<Plan>> quickestChoice(const PlanRequest& request, const JobContext& job) {
    auto best = improved(request, job);
    if (!best) {
        return std::unexpected(best.error());
    }
    Result<void> tried;
    if (!request.draft && !hasOwnOrder(request.settings)) {
        for (const SimplerChoice& choice : kSimplerChoices) {
            tried = tried.and_then([&] { return trySimpler(*best, choice, job); });
        }
    }
    if (!tried) {
        return std::unexpected(tried.error());
    }
    best->plan->request = request;
    best->plan->instead = std::move(best->instead);
    best->plan->notes = std::move(best->notes);
    return std::move(best->plan);
}

}  // namespace furrow
