#include "planner/plan/best_plan.h"

#include "planner/decomposition/decomposition.h"
#include "planner/field/small_obstacles.h"
#include "planner/headland/methods.h"
#include "planner/jobs/parallel.h"
#include "planner/jobs/shared_progress.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan_chooser.h"
#include "planner/plan/quicker_choice.h"
#include "planner/plan/round_stage.h"
#include "planner/plan/shown_value.h"
#include "planner/plan/stopwatch.h"
#include "planner/route/methods.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace furrow {

namespace {

constexpr int kMostRounds = 4;
// Anything below is no reason to drive a field in another way.
constexpr double kWorthIt = 0.001;
constexpr std::size_t kMostHeadingsTried = 6;
constexpr Angle kSameAsNow = degrees(0.05);
// That most searches take; the progress counts on it.
constexpr double kUsualRounds = 2.0;

constexpr PlanChoice kHeadland{.id = "headland", .name = "Headland"};
constexpr PlanChoice kHeading{.id = "heading", .name = "Heading"};
constexpr PlanChoice kCells{.id = "cells", .name = "Blocks"};
constexpr PlanChoice kSwathOrder{.id = "order", .name = "Order of swaths"};
constexpr PlanChoice kLast{.id = "last-pass", .name = "Last pass"};
constexpr PlanChoice kSwathEnds{.id = "ends", .name = "Ends of swaths"};
constexpr PlanChoice kObstacles{.id = "obstacles", .name = "Small obstacles"};
constexpr PlanChoice kPasses{.id = "headland-passes", .name = "Headland passes"};

const Message kHeadingOfCells{"Heading of blocks"};

using Changes = std::vector<SettingChange>;

struct Alternative {
    Message text;
    Changes changes;
};

/// A choice with what it may be changed to.
struct ChoiceRule {
    PlanChoice choice;
    /// Its settings: given ones say that it was made.
    std::vector<std::string_view> keys;
    bool concernsSwaths = true;  ///< other swaths would follow, or others of their places
    std::vector<Alternative> (*alternatives)(const BestSoFar& best);
};

const Parameter& parameterOf(std::string_view key) {
    return **findParameter(key);
}

/// @param name  said instead of the setting's, where that needs its panel to be understood
Alternative withValue(std::string_view key, std::string value, std::string_view name = {}) {
    const Parameter& parameter = parameterOf(key);
    Settings settings;
    if (!value.empty()) {
        settings.setText(parameter, value).value();
    }
    return {.text = message("{}: {}", Message{name.empty() ? parameter.name : name},
                            shownValue(parameter, settings.value(parameter))),
            .changes = {{std::string{key}, std::move(value)}}};
}

/// All other values of a setting.
std::vector<Alternative> others(const BestSoFar& best, std::string_view key, std::string_view name = {}) {
    const Parameter& parameter = parameterOf(key);
    const std::string now = best.asked.settings.choice(parameter);
    std::vector<Alternative> found;
    for (const Choice& choice : parameter.choices) {
        if (choice.id != now) {
            found.push_back(withValue(key, std::string{choice.id}, name));
        }
    }
    return found;
}

std::vector<Alternative> headlands(const BestSoFar& best) {
    std::vector<Alternative> found = others(best, "headland.method");
    const Settings& settings = best.asked.settings;
    if (headlandMethod(settings).traits.isOneWidth) {
        const int passes = best.plan.laidOut.headland->passes;
        for (const int other : {passes - 1, passes + 1}) {
            if (other > 0) {
                Alternative alternative = withValue("headland.passes", std::to_string(other), kPasses.name);
                if (settings.isSet(kHeadlandWidth)) {
                    alternative.changes.push_back({std::string{kHeadlandWidth.key}, {}});
                }
                found.push_back(std::move(alternative));
            }
        }
    }
    return found;
}

Changes searchedHeading() {
    return {{"swaths.method", {}}, {"swaths.angle_deg", {}}};
}

/// The heading that the search finds by each objective, those that came near, and those of long edges.
std::vector<Alternative> headings(const BestSoFar& best) {
    std::vector<Alternative> found;
    const Settings& settings = best.asked.settings;
    const Angle now = best.plan.laidOut.laid->swaths.heading;
    for (const HeadingCandidate& candidate : best.headings) {
        if (hasHeadingPerCell(settings)) {
            break;
        }
        if (found.size() < kMostHeadingsTried && angleBetweenLines(candidate.heading, now) > kSameAsNow) {
            found.push_back(
                {.text = message("Heading: bearing {:.1f} degrees", lineBearingDeg(candidate.heading)),
                 .changes = {{"swaths.method", std::string{kFixedHeadingMethod.info.id}},
                             {"swaths.angle_deg", settingText(inDegrees(candidate.heading))}}});
        }
    }
    const bool isSearched = swathMethod(settings).traits.searchesHeadings;
    for (const Choice& objective : kObjective.choices) {
        if (isSearched && objective.id == settings.choice(kObjective)) {
            continue;
        }
        Alternative other = withValue(kObjective.key, std::string{objective.id}, kHeading.name);
        if (!isSearched) {
            std::ranges::move(searchedHeading(), std::back_inserter(other.changes));
        }
        found.push_back(std::move(other));
    }
    return found;
}

/// A heading for each cell is searched; one by hand holds for all of them.
std::vector<Alternative> cells(const BestSoFar& best) {
    std::vector<Alternative> found = others(best, "decomposition.method");
    const bool isSearched = swathMethod(best.asked.settings).traits.searchesHeadings;
    for (Alternative& other : others(best, kCellHeading.key, kHeadingOfCells.text())) {
        if (!isSearched) {
            std::ranges::move(searchedHeading(), std::back_inserter(other.changes));
        }
        found.push_back(std::move(other));
    }
    return found;
}

std::vector<Alternative> orders(const BestSoFar& best) {
    std::vector<Alternative> found = others(best, "route.method", kSwathOrder.name);
    std::erase_if(
        found, [](const Alternative& each) { return each.changes.front().value == kCustomMethod.info.id; });
    return found;
}

std::vector<Alternative> lastPasses(const BestSoFar& best) {
    std::vector<Alternative> found = others(best, kLastPass.key);
    std::erase_if(found, [](const Alternative& each) { return each.changes.front().value == "gap"; });
    return found;
}

std::vector<Alternative> ends(const BestSoFar& best) {
    return others(best, kEnds.key);
}

/// Round none of the small obstacles, or round those that are small enough.
std::vector<Alternative> obstacles(const BestSoFar& best) {
    const Settings& settings = best.asked.settings;
    const Length now = roundUpTo(settings, best.asked.machine);
    Settings standard = settings;
    standard.clear(kRoundUpTo);
    const Length usual = roundUpTo(standard, best.asked.machine);
    if (smallObstacles(*best.asked.field, std::max(now, usual)).empty()) {
        return {};
    }
    return {now > Length{} ? withValue(kRoundUpTo.key, "0") : withValue(kRoundUpTo.key, {})};
}

std::vector<Alternative> headlandPasses(const BestSoFar& best) {
    std::vector<Alternative> found;
    if (!best.plan.laidOut.headland->drivenPasses.empty()) {
        for (const std::string_view key : {"headland.order", "headland.direction"}) {
            std::ranges::move(others(best, key, kPasses.name), std::back_inserter(found));
        }
    }
    return found;
}

std::span<const ChoiceRule> rules() {
    static const std::array<ChoiceRule, 8> all{
        {{.choice = kHeadland,
          .keys = {"headland.method", "headland.passes", "headland.width_m"},
          .alternatives = headlands},
         {.choice = kHeading,
          .keys = {"swaths.method", "swaths.angle_deg", "swaths.objective", "swaths.prefer_edge_percent"},
          .alternatives = headings},
         {.choice = kCells,
          .keys = {"decomposition.method", "decomposition.heading", "decomposition.split"},
          .alternatives = cells},
         {.choice = kSwathOrder,
          .keys = {"route.method", "route.objective", "route.locked", "route.first", "route.last",
                   "route.open_strips"},
          .alternatives = orders},
         {.choice = kLast, .keys = {"swaths.last_pass"}, .alternatives = lastPasses},
         {.choice = kSwathEnds, .keys = {"swaths.ends"}, .alternatives = ends},
         {.choice = kObstacles, .keys = {"swaths.round_up_to_m"}, .alternatives = obstacles},
         {.choice = kPasses,
          .keys = {"headland.order", "headland.direction"},
          .concernsSwaths = false,
          .alternatives = headlandPasses}}};
    return all;
}

Result<Settings> withChanges(Settings settings, const Changes& changes) {
    for (const SettingChange& change : changes) {
        const Parameter& parameter = parameterOf(change.key);
        if (change.value.empty()) {
            settings.clear(parameter);
        } else if (auto set = settings.setText(parameter, change.value); !set) {
            return std::unexpected(set.error());
        }
    }
    return settings;
}

bool isWorthIt(const PlannedStages& other, const PlannedStages& best) {
    return isBetter(other, best) &&
           (other.blockingCount() < best.blockingCount() || timeOf(other) < (1.0 - kWorthIt) * timeOf(best));
}

/// Changes one choice after the other to its best alternative.
class ChoiceSearch {
public:
    ChoiceSearch(StageRunner& runner, const BestPlanTask& task, const JobContext& job)
        : runner_{runner}, chooser_{runner}, task_{task}, job_{job} {
        const bool keepsSwaths = hasOwnOrder(task.request.settings);
        for (const ChoiceRule& rule : rules()) {
            if (!std::ranges::contains(task.kept, rule.choice.id) && !(keepsSwaths && rule.concernsSwaths)) {
                free_.push_back(&rule);
            }
        }
    }

    Result<BestSoFar> run();

    bool hasTaken() const { return !taken_.empty(); }
    ChoiceTable table(const Settings& found) &&;

private:
    Result<bool> change(BestSoFar& best, const ChoiceRule& rule, const JobContext& job);
    bool mayChange(const Changes& changes) const;
    void tell(const Settings& settings, const PlannedStages& plan) const {
        if (task_.onBetter) {
            task_.onBetter(settings, timeOf(plan));
        }
    }

    StageRunner& runner_;
    PlanChooser chooser_;
    const BestPlanTask& task_;
    JobContext job_;
    std::vector<const ChoiceRule*> free_;
    std::vector<TriedChoice> taken_;
    std::map<const ChoiceRule*, std::vector<TriedChoice>> left_;  ///< of the last round
    ChoiceTable table_;
};

/// Whether no setting of a choice that is kept would change.
bool ChoiceSearch::mayChange(const Changes& changes) const {
    return std::ranges::none_of(changes, [&](const SettingChange& change) {
        return std::ranges::any_of(rules(), [&](const ChoiceRule& rule) {
            return std::ranges::contains(rule.keys, change.key) && !std::ranges::contains(free_, &rule);
        });
    });
}

/// Takes the best alternative, if one is worth it.
Result<bool> ChoiceSearch::change(BestSoFar& best, const ChoiceRule& rule, const JobContext& job) {
    std::vector<Alternative> alternatives = rule.alternatives(best);
    std::erase_if(alternatives, [&](const Alternative& each) { return !mayChange(each.changes); });
    SharedProgress progress{alternatives.size(), job};
    auto made = parallelMap<Result<std::optional<BestSoFar>>>(
        alternatives.size(),
        [&](std::size_t i) -> Result<std::optional<BestSoFar>> {
            auto settings = withChanges(best.asked.settings, alternatives[i].changes);
            if (!settings) {
                return std::optional<BestSoFar>{};
            }
            PlanRequest asked = best.asked;
            asked.settings = *std::move(settings);
            return chooser_.changed(best, asked, progress.piece(i));
        },
        job.withoutProgress());
    if (!made) {
        return std::unexpected(made.error());
    }
    table_.alternatives += alternatives.size();
    std::optional<std::size_t> chosen;
    std::vector<TriedChoice>& left = left_[&rule];
    left.clear();
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
        const auto& other = (*made)[i];
        if (!other) {
            return std::unexpected(other.error());
        }
        TriedChoice tried{
            .choice = rule.choice.id, .text = alternatives[i].text, .changes = alternatives[i].changes};
        if (*other) {
            tried.worth = TriedChoice::Worth::Slower;
            tried.difference = timeOf((*other)->plan) - timeOf(best.plan);
            if (isWorthIt((*other)->plan, best.plan) &&
                (!chosen || isBetter((*other)->plan, (**(*made)[*chosen]).plan))) {
                chosen = i;
            }
        }
        left.push_back(std::move(tried));
    }
    if (!chosen) {
        return false;
    }
    TriedChoice taken = left[*chosen];
    taken.worth = TriedChoice::Worth::Taken;
    const BestSoFar& other = **(*made)[*chosen];
    taken.difference = other.plan.blockingCount() < best.plan.blockingCount()
                           ? Duration{}
                           : timeOf(best.plan) - timeOf(other.plan);
    taken_.push_back(std::move(taken));
    std::vector<HeadingCandidate> headings = std::move(best.headings);
    best = **std::move((*made)[*chosen]);
    // A heading by hand has no others beside it.
    best.headings = best.plan.laidOut.laid->swaths.candidates;
    if (best.headings.empty()) {
        best.headings = std::move(headings);
    }
    tell(best.asked.settings, best.plan);
    return true;
}

Result<BestSoFar> ChoiceSearch::run() {
    // With what the planner decides by itself: that is the plan to compare with.
    auto best = quickestChoice(task_.request, runner_, job_.part(0.0, 0.1));
    if (!best) {
        return best;
    }
    tell(task_.request.settings, best->plan);
    table_.asked = timeOf(best->plan);
    table_.askedProblems = best->plan.blockingCount();
    // The heading that the driven path decided for, whatever is changed from here on.
    const bool isHeadingFree = mayChange(searchedHeading());
    if (const Settings& used = best->plan.request.settings;
        isHeadingFree && !(used.value(kAngle) == best->asked.settings.value(kAngle))) {
        best->asked = along(best->asked, *used.angle(kAngle));
    }
    const std::size_t most = kMostRounds * free_.size();
    std::size_t unchanged = 0;
    for (std::size_t i = 0; i < most && unchanged < free_.size(); ++i) {
        const auto share = [&](std::size_t done) {
            const double rounds = static_cast<double>(done) / static_cast<double>(free_.size());
            return 0.1 + 0.8 * std::min(1.0, rounds / kUsualRounds);
        };
        const auto isChanged = change(*best, *free_[i % free_.size()], job_.part(share(i), share(i + 1)));
        if (!isChanged) {
            return std::unexpected(isChanged.error());
        }
        unchanged = *isChanged ? 0 : unchanged + 1;
        job_.report(share(i + 1));
    }
    table_.best = timeOf(best->plan);
    return best;
}

/// What was taken and later given up for something else is left out.
ChoiceTable ChoiceSearch::table(const Settings& found) && {
    const auto changes = [](const Settings& settings, const TriedChoice& tried) {
        return withChanges(settings, tried.changes).value() != settings;
    };
    for (const ChoiceRule* const rule : free_) {
        std::ranges::copy_if(taken_, std::back_inserter(table_.tried), [&](const TriedChoice& tried) {
            return tried.choice == rule->choice.id && !changes(found, tried) &&
                   changes(task_.request.settings, tried);
        });
        std::ranges::move(left_[rule], std::back_inserter(table_.tried));
    }
    return std::move(table_);
}

/// The plan of the best settings: with what is left to the planner, if that comes to the same.
Result<std::shared_ptr<const Plan>> planOf(const BestSoFar& best, const JobContext& job, StageCache& cache) {
    const auto isAsGood = [&](const Plan& plan) {
        return plan.blockingCount() <= best.plan.blockingCount() &&
               timeForAll(plan.request.machine, plan.path, plan.audit) <=
                   (1.0 + kWorthIt) * timeOf(best.plan);
    };
    auto plan = makePlan(best.asked, job, &cache);
    if (!plan || isAsGood(**plan)) {
        return plan;
    }
    return makePlan(best.plan.request, job.withoutProgress(), &cache);
}

}  // namespace

std::span<const PlanChoice> planChoices() {
    static const std::vector<PlanChoice> all = [] {
        std::vector<PlanChoice> choices;
        for (const ChoiceRule& rule : rules()) {
            choices.push_back(rule.choice);
        }
        return choices;
    }();
    return all;
}

bool isGiven(const PlanChoice& choice, const Settings& settings) {
    const auto rule =
        std::ranges::find(rules(), choice.id, [](const ChoiceRule& each) { return each.choice.id; });
    return std::ranges::any_of(rule->keys,
                               [&](std::string_view key) { return settings.isSet(parameterOf(key)); });
}

Result<std::shared_ptr<const Plan>> bestPlan(const BestPlanTask& task, const JobContext& job,
                                             StageCache* cache) {
    Stopwatch watch;
    StageCache ownCache;
    StageCache& stageCache = cache != nullptr ? *cache : ownCache;
    StageRunner runner{stageCache};
    BestPlanTask compared = task;
    compared.request.settings.clear(kCompare);
    ChoiceSearch search{runner, compared, job};
    const auto best = search.run();
    if (!best) {
        return std::unexpected(best.error());
    }
    const JobContext last = job.part(0.9, 1.0);
    const auto plan =
        search.hasTaken() ? planOf(*best, last, stageCache) : makePlan(compared.request, last, &stageCache);
    if (!plan) {
        return plan;
    }
    auto told = std::make_shared<Plan>(**plan);
    told->choices = std::move(search).table(best->asked.settings);
    told->timings.total = watch.lap();
    return told;
}

}  // namespace furrow
