#include "planner/plan/quicker_choice.h"

#include "planner/decomposition/decomposition.h"
#include "planner/plan/as_asked.h"
#include "planner/plan/method_registry.h"
#include "planner/route/methods.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <iterator>
#include <utility>

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

/// The plan of another heading where that is better as driven.
Result<std::shared_ptr<Plan>> withBestHeading(std::shared_ptr<Plan> best, const PlanRequest& request, const JobContext& job) {
    const std::shared_ptr<Plan> searched = best;
    for (const HeadingCandidate& candidate : headingsToTry(*searched)) {
        auto other = planAsAsked(along(request, candidate.heading), job.quiet());
        if (!other && other.error().code == ErrorCode::Cancelled) {
            return other;
        }
        if (other && isBetter(**other, *best)) {
            best = std::move(*other);
            best->notes = {{anotherHeading(candidate, reasonFor(*best, *searched)), "instead", {}}};
        }
    }
    return best;
}

}  // namespace

Duration timeForAll(const Plan& plan) {
    const Machine& machine = plan.request.machine;
    const double missedM = plan.audit.missed.value_or(Area{}).si() / machine.operatingWidth().si();
    return plan.path.duration() + seconds(missedM / machine.spec().tractor.workingSpeed.si());
}

Result<std::shared_ptr<Plan>> quickestChoice(const PlanRequest& request, const JobContext& job) {
    auto best = planAsAsked(request, job);
    // An order of one's own names the swaths of just these choices.
    const bool hasOwnOrder = routeMethod(request.settings) == kCustomMethod.run;
    if (!best || request.draft || hasOwnOrder) {
        return best;
    }
    const bool perCell = request.settings.choice(kCellHeading) == "per-cell";
    if (!perCell) {
        best = withBestHeading(std::move(*best), request, job);
        if (!best) {
            return best;
        }
    }
    PlanRequest tried = request;
    std::vector<SettingChange> instead;
    std::vector<Note> notes;
    for (const SimplerChoice& choice : kSimplerChoices) {
        const Parameter& parameter = **findParameter(choice.key);
        if (tried.settings.choice(parameter) != choice.chosen) {
            continue;
        }
        PlanRequest simpler = tried;
        if (auto set = simpler.settings.setText(parameter, choice.simpler); !set) {
            return std::unexpected(set.error());
        }
        auto other = planAsAsked(simpler, job.quiet());
        if (!other && other.error().code == ErrorCode::Cancelled) {
            return std::unexpected(other.error());
        }
        if (other && isBetter(**other, **best)) {
            notes.push_back({takenInstead(parameter, choice, reasonFor(**other, **best)), "instead", {}});
            instead.push_back({std::string{choice.key}, std::string{choice.simpler}});
            tried = std::move(simpler);
            best = std::move(other);
        }
    }
    (*best)->request = request;
    (*best)->instead = std::move(instead);
    std::ranges::move(notes, std::back_inserter((*best)->notes));
    return best;
}

}  // namespace furrow
