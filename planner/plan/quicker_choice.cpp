#include "planner/plan/quicker_choice.h"

#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan_chooser.h"

#include <algorithm>
#include <iterator>
#include <string>
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

// With this share of the field as mainland, another number of headland passes saves little.
constexpr double kMuchMainland = 0.7;
constexpr int kTwoPasses = 2;

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
Result<void> tryFewerPasses(PlanChooser& chooser, BestSoFar& best) {
    const Settings& asked = best.asked.settings;
    if (!headlandMethod(asked).traits.isOneWidth || asked.isSet(kHeadlandWidth) ||
        asked.isSet(kHeadlandPasses)) {
        return {};
    }
    while (mayHaveFewerPasses(best.plan)) {
        const int passes = best.plan.laidOut.headland->passes - 1;
        PlanRequest fewer = best.asked;
        fewer.settings.set(kHeadlandPasses, static_cast<double>(passes)).value();
        auto other = chooser.changed(best, fewer);
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
Result<void> trySimpler(PlanChooser& chooser, BestSoFar& best, const SimplerChoice& choice) {
    const Parameter& parameter = **findParameter(choice.key);
    if (best.asked.settings.choice(parameter) != choice.chosen) {
        return {};
    }
    PlanRequest simpler = best.asked;
    if (auto set = simpler.settings.setText(parameter, choice.simpler); !set) {
        return set;
    }
    auto other = chooser.improved(simpler, {});
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

Result<QuickestChoice> quickestChoice(const PlanRequest& request, StageRunner& runner,
                                      const JobContext& job) {
    PlanChooser chooser{runner, job};
    auto best = chooser.improved(request, job.progress);
    if (!best) {
        return std::unexpected(best.error());
    }
    Result<void> tried;
    if (!request.draft && !hasOwnOrder(request.settings)) {
        tried = tryFewerPasses(chooser, *best);
        for (const SimplerChoice& choice : kSimplerChoices) {
            tried = tried.and_then([&] { return trySimpler(chooser, *best, choice); });
        }
    }
    return tried.transform([&] {
        return QuickestChoice{std::move(best->plan), std::move(best->instead), std::move(best->notes),
                              std::move(best->headings)};
    });
}

}  // namespace furrow
