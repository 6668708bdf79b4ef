#include "planner/plan/quicker_choice.h"

#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan_chooser.h"

#include <algorithm>
#include <atomic>
#include <iterator>
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

// With this share of the field as mainland, another number of headland passes saves little.
constexpr double kMuchMainland = 0.7;
constexpr int kTwoPasses = 2;
// Shares of the progress: all but fewer passes, where those are worth a look and where not; the plan as asked
// beside a simpler one; of what is left for fewer passes one less of them.
constexpr double kBesideFewer = 0.5;
constexpr double kBesideNone = 0.95;
constexpr double kBesideSimpler = 0.5;
constexpr double kOnePassLess = 0.6;

std::string_view choiceName(const Parameter& parameter, std::string_view id) {
    return std::ranges::find(parameter.choices, id, &Choice::id)->name;
}

Message takenInstead(const Parameter& parameter, const SimplerChoice& choice, const Message& reason) {
    return message("\"{}\": \"{}\" is planned instead of \"{}\": {}", parameter.name,
                   choiceName(parameter, choice.simpler), choiceName(parameter, choice.chosen), reason);
}

Message fewerPasses(int passes, const Message& reason) {
    return message("A headland of {} is planned instead of one that is wide enough for turns: {}",
                   counted("{} pass", "{} passes", passes), reason);
}

/// Whether two passes of headland take much of the field, or leave the plan blocked, or one takes all of it.
/// More than two are needed for turns: fewer of them save no time.
bool mayHaveFewerPasses(const PlannedStages& plan) {
    const Headland& headland = *plan.laidOut.headland;
    return headland.isPerimeterOnly ||
           (headland.passes == kTwoPasses && (!plan.drivable() || headland.mainlandRatio < kMuchMainland));
}

/// Takes the plan with fewer headland passes where that is quicker, each as good as it gets. Cancelled.
Result<void> tryFewerPasses(PlanChooser& chooser, BestSoFar& best, const JobContext& job) {
    const Settings& asked = best.asked.settings;
    if (!headlandMethod(asked).traits.isOneWidth || asked.isSet(kHeadlandWidth) ||
        asked.isSet(kHeadlandPasses)) {
        return {};
    }
    for (double begun = 0.0; mayHaveFewerPasses(best.plan);) {
        const double end = begun + kOnePassLess * (1.0 - begun);
        const int passes = best.plan.laidOut.headland->passes - 1;
        PlanRequest fewer = best.asked;
        fewer.settings.set(kHeadlandPasses, static_cast<double>(passes)).value();
        auto other = chooser.changed(best, fewer, job.part(begun, end));
        begun = end;
        if (!other || !*other || !isBetter((*other)->plan, best.plan)) {
            return other.transform([](auto&&) {});
        }
        (*other)->headings = (*other)->plan.laidOut.laid->swaths.candidates;
        (*other)->notes = {{fewerPasses(passes, reasonFor((*other)->plan, best.plan)), "instead", {}}};
        note((*other)->instead, kHeadlandPasses, std::to_string(passes));
        best = **std::move(other);
    }
    return {};
}

/// Takes the plan with the simpler choice where that is quicker, each as good as it gets. Cancelled.
Result<void> trySimpler(PlanChooser& chooser, BestSoFar& best, const SimplerChoice& choice,
                        const JobContext& job) {
    const Parameter& parameter = **findParameter(choice.key);
    if (best.asked.settings.choice(parameter) != choice.chosen) {
        return {};
    }
    PlanRequest simpler = best.asked;
    if (auto set = simpler.settings.setText(parameter, choice.simpler); !set) {
        return set;
    }
    auto other = chooser.improved(simpler, job);
    if (!other) {
        return other.error().code == ErrorCode::Cancelled ? Result<void>{std::unexpected(other.error())}
                                                          : Result<void>{};
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

Result<BestSoFar> quickestChoice(const PlanRequest& request, StageRunner& runner, const JobContext& job,
                                 ChoosingCourse course) {
    const bool compares = !request.draft && !hasOwnOrder(request.settings);
    std::vector<const SimplerChoice*> simpler;
    for (const SimplerChoice& choice : kSimplerChoices) {
        if (compares && request.settings.choice(**findParameter(choice.key)) == choice.chosen) {
            simpler.push_back(&choice);
        }
    }
    const double asked = simpler.empty() ? 1.0 : kBesideSimpler;
    // How much is left for fewer passes is known with the plan as asked: the rest takes as much less.
    std::atomic<double> improved = compares ? kBesideNone : 1.0;
    ChoosingCourse told{.asked =
                            [&, isTold = false](const PlannedStages& plan) mutable {
                                // The plan with a simpler choice is one that nobody asked for.
                                if (std::exchange(isTold, true)) {
                                    return;
                                }
                                improved =
                                    compares && mayHaveFewerPasses(plan) ? kBesideFewer : improved.load();
                                if (course.asked) {
                                    course.asked(plan);
                                }
                            },
                        .compared = course.compared};
    PlanChooser chooser{runner, std::move(told)};
    const JobContext whole = job.part(0.0, asked);
    JobContext improving = whole.withoutProgress();
    if (whole.progress) {
        improving.progress = [&](double share) {
            constexpr double kBegun = kBesideFewer * kAskedShare;
            whole.report(share < kAskedShare
                             ? kBesideFewer * share
                             : kBegun + (share - kAskedShare) / (1.0 - kAskedShare) * (improved - kBegun));
        };
    }
    auto best = chooser.improved(request, improving);
    if (!best) {
        return std::unexpected(best.error());
    }
    Result<void> tried;
    if (compares && isCompared(best->plan) && !isTooLargeToCompare(best->plan)) {
        tried = tryFewerPasses(chooser, *best, whole.part(improved, 1.0));
        const double each = (1.0 - asked) / static_cast<double>(std::max<std::size_t>(1, simpler.size()));
        for (std::size_t i = 0; i < simpler.size(); ++i) {
            const double begun = asked + each * static_cast<double>(i);
            tried = tried.and_then(
                [&] { return trySimpler(chooser, *best, *simpler[i], job.part(begun, begun + each)); });
        }
    }
    return tried.transform([&] { return *std::move(best); });
}

}  // namespace furrow
