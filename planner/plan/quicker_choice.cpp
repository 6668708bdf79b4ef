#include "planner/plan/quicker_choice.h"

#include "planner/headland/methods.h"
#include "planner/decomposition/decomposition.h"
#include "planner/plan/as_asked.h"
#include "planner/plan/method_registry.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
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

std::ptrdiff_t blockingCount(const Plan& plan) {
    return std::ranges::count(plan.findings, Severity::Blocking, &Finding::severity);
}

bool isBetter(const Plan& other, const Plan& plan) {
    if (blockingCount(other) != blockingCount(plan)) {
        return blockingCount(other) < blockingCount(plan);
    }
    return timeForAll(other) < timeForAll(plan);
}

/// Without progress: what is compared with takes no part of it.
JobContext quiet(const JobContext& job) {
    return {job.stop, {}, job.threads};
}

Message takenInstead(const Parameter& parameter, const SimplerChoice& choice, Duration saved) {
    const std::string_view asked = choiceName(parameter, choice.chosen);
    const std::string_view taken = choiceName(parameter, choice.simpler);
    return saved > Duration{} ? message("\"{}\": \"{}\" is planned instead of \"{}\", since it is {:.0f} s quicker here",
                                        parameter.name, taken, asked, saved.si())
                              : message("\"{}\": \"{}\" is planned instead of \"{}\", which cannot be driven here",
                                        parameter.name, taken, asked);
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
        const double apart = std::abs(std::remainder((each.heading - plan.swaths.heading).si(), std::numbers::pi));
        const bool isNear = each.alongLongestEdge && each.figures.time < kNearTime * quickest;
        if (radians(apart) > kSameHeading && (isNear || !plan.drivable()) && headings.size() < kMostHeadings) {
            headings.push_back(each);
        }
    }
    return headings;
}

Message anotherHeading(const HeadingCandidate& taken, Duration saved) {
    const Message line = taken.alongLongestEdge ? Message{"Swaths along the longest edge"}
                                                : message("Swaths at a bearing of {:.1f} degrees", lineBearingDeg(taken.heading));
    return saved > Duration{} ? message("{} are planned, since as driven they are {:.0f} s quicker than the heading that the "
                                        "search estimates to be the quickest",
                                        line, saved.si())
                              : message("{} are planned, since the quickest heading cannot be driven here", line);
}

/// The plan of another heading where that is better as driven.
Result<std::shared_ptr<Plan>> withBestHeading(std::shared_ptr<Plan> best, const PlanRequest& request, const JobContext& job) {
    const std::shared_ptr<Plan> searched = best;
    for (const HeadingCandidate& candidate : headingsToTry(*searched)) {
        auto other = planAsAsked(along(request, candidate.heading), quiet(job));
        if (!other && other.error().code == ErrorCode::Cancelled) {
            return other;
        }
        if (other && isBetter(**other, *best)) {
            const Duration saved = searched->path.duration() - (*other)->path.duration();
            best = std::move(*other);
            best->notes = {{anotherHeading(candidate, searched->drivable() ? saved : Duration{}), "instead", {}}};
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
    if (!best || request.draft) {
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
        auto other = planAsAsked(simpler, quiet(job));
        if (!other && other.error().code == ErrorCode::Cancelled) {
            return std::unexpected(other.error());
        }
        if (other && isBetter(**other, **best)) {
            const Duration saved = (*best)->path.duration() - (*other)->path.duration();
            notes.push_back({takenInstead(parameter, choice, saved), "instead", {}});
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
