#include "planner/plan/quicker_choice.h"

#include "planner/decomposition/decomposition.h"
#include "planner/headland/headland_passes.h"
#include "planner/plan/as_asked.h"
#include "planner/plan/method_registry.h"
#include "planner/route/methods.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
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

// A heading whose estimate is slower by more is not the quickest as driven either.
constexpr double kNearTime = 1.05;
constexpr Angle kSameHeading = degrees(0.01);
constexpr std::size_t kMostHeadings = 2;

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

/// Headings that the search found near the best: along the longest edge where that is not much slower by the estimate;
/// all of them where the best one cannot be driven.
std::vector<HeadingCandidate> headingsToTry(const Plan& plan) {
    std::vector<HeadingCandidate> headings;
    const std::vector<HeadingCandidate>& all = plan.swaths.candidates;
    if (all.empty()) {
        return headings;
    }
    const Duration quickest = std::ranges::min_element(all, {}, [](const auto& each) { return each.figures.time; })->figures.time;
    for (const HeadingCandidate& each : all) {
        const bool isNear = each.alongLongestEdge && each.figures.time < kNearTime * quickest;
        if (angleBetweenLines(each.heading, plan.swaths.heading) > kSameHeading && (isNear || !plan.drivable()) && headings.size() < kMostHeadings) {
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
    PlanRequest request;
    std::shared_ptr<Plan> plan;
    std::vector<SettingChange> instead;
    std::vector<Note> notes;
};

/// Takes the plan with other settings where it is better as driven: whether it did. One that cannot be made is no better.
/// Cancelled.
Result<bool> takeIfBetter(Best& best, PlanRequest other, const JobContext& job) {
    auto plan = planAsAsked(other, job.quiet());
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

Result<void> tryHeadings(Best& best, const JobContext& job) {
    const Best searched = best;
    for (const HeadingCandidate& candidate : headingsToTry(*searched.plan)) {
        const auto taken = takeIfBetter(best, along(searched.request, candidate.heading), job);
        if (!taken) {
            return std::unexpected(taken.error());
        }
        if (*taken) {
            best.notes = searched.notes;
            best.notes.push_back({anotherHeading(candidate, reasonFor(*best.plan, *searched.plan)), "instead", {}});
        }
    }
    return {};
}

Result<void> trySimpler(Best& best, const SimplerChoice& choice, const JobContext& job) {
    const Parameter& parameter = **findParameter(choice.key);
    if (best.request.settings.choice(parameter) != choice.chosen) {
        return {};
    }
    PlanRequest simpler = best.request;
    if (auto set = simpler.settings.setText(parameter, choice.simpler); !set) {
        return set;
    }
    const std::shared_ptr<Plan> before = best.plan;
    const auto taken = takeIfBetter(best, std::move(simpler), job);
    if (!taken) {
        return std::unexpected(taken.error());
    }
    if (*taken) {
        best.notes.push_back({takenInstead(parameter, choice, reasonFor(*best.plan, *before)), "instead", {}});
        best.instead.push_back({std::string{choice.key}, std::string{choice.simpler}});
    }
    return {};
}

/// Those that reach into corners are much alike: the second is tried where the first is no better.
Result<void> tryCorners(Best& best, const JobContext& job) {
    if (best.request.settings.choice(kHeadlandCorner) != kQuickestCorner || best.plan->headland.rings.empty()) {
        return {};
    }
    std::string_view corner = kRoundedCorner;
    for (const std::string_view other : {kLoopCorner, kReverseCorner}) {
        if (!best.plan->drivable() || corner != kRoundedCorner) {
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

}  // namespace

Duration timeForAll(const Plan& plan) {
    const Machine& machine = plan.request.machine;
    const double missedM = plan.audit.missed.value_or(Area{}).si() / machine.operatingWidth().si();
    return plan.path.duration() + seconds(missedM / machine.spec().tractor.workingSpeed.si());
}

Result<std::shared_ptr<Plan>> quickestChoice(const PlanRequest& request, const JobContext& job) {
    auto asked = planAsAsked(request, job);
    if (!asked || request.draft) {
        return asked;
    }
    Best best{.request = request, .plan = std::move(*asked), .instead = {}, .notes = {}};
    Result<void> tried;
    if (!hasOwnOrder(request.settings)) {
        // What is simpler first, so that from there on all is as if that had been asked for.
        for (const SimplerChoice& choice : kSimplerChoices) {
            tried = tried.and_then([&] { return trySimpler(best, choice, job); });
        }
        if (best.request.settings.choice(kCellHeading) != "per-cell") {
            tried = tried.and_then([&] { return tryHeadings(best, job); });
        }
    }
    tried = tried.and_then([&] { return tryCorners(best, job); });
    if (!tried) {
        return std::unexpected(tried.error());
    }
    best.plan->request = request;
    best.plan->instead = std::move(best.instead);
    best.plan->notes = std::move(best.notes);
    return std::move(best.plan);
}

}  // namespace furrow
