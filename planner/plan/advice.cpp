#include "planner/plan/advice.h"

#include "planner/headland/methods.h"
#include "planner/path/gate_ways.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/narrow_places.h"
#include "planner/plan/shown_value.h"

#include <algorithm>
#include <ranges>
#include <vector>

namespace furrow {

namespace {

constexpr std::size_t kMostTried = 4;
// Findings of one kind in two plans are the same no farther apart than this, or than two operating widths.
constexpr double kNearM = 10.0;
constexpr double kNearWidths = 2.0;

struct Change {
    const Parameter* parameter = nullptr;
    std::string value;
};

/// Ways between parts of the field that no setting joins are told as such.
bool leavesUnexplained(const Finding& finding) {
    return finding.severity == Severity::Blocking && finding.kind == FindingKind::Outside &&
           finding.suggestion.empty();
}

/// What might mend a plan: of the settings that were given those of the last stages first, since they change
/// least of it.
std::vector<Change> changesFor(const Plan& plan) {
    const Settings& settings = plan.request.settings;
    std::vector<Change> changes;
    for (const Parameter* parameter : allParameters() | std::views::reverse) {
        Settings without = settings;
        without.clear(*parameter);
        // Without refill points nobody would look whether the tank runs empty. For a plan that blocks, others
        // are compared whatever is set.
        if (parameter != &kRouteRefill && parameter != &kCompare && settings.isSet(*parameter) &&
            without.value(*parameter) != settings.value(*parameter)) {
            changes.push_back({parameter, settingText(without.value(*parameter))});
        }
    }
    const bool leaves = std::ranges::any_of(plan.findings, leavesUnexplained);
    const bool canWiden = headlandMethod(settings).traits.isOneWidth && !settings.isSet(kHeadlandWidth);
    if (leaves && canWiden && !plan.headland.narrowed) {
        changes.push_back({&kHeadlandPasses, std::to_string(plan.headland.passes + 1)});
    }
    if (changes.size() > kMostTried) {
        changes.resize(kMostTried);
    }
    return changes;
}

bool hasNear(const std::vector<Finding>& findings, const Finding& wanted, double nearM) {
    return std::ranges::any_of(findings, [&](const Finding& finding) {
        return finding.severity == Severity::Blocking && finding.kind == wanted.kind &&
               distance(finding.place, wanted.place) < nearM;
    });
}

std::ptrdiff_t blockingOfKind(const Plan& plan, FindingKind kind) {
    return std::ranges::count_if(plan.findings, [kind](const Finding& finding) {
        return finding.severity == Severity::Blocking && finding.kind == kind;
    });
}

bool isBlockedAnew(const Plan& changed, const Plan& plan, double nearM) {
    return std::ranges::any_of(changed.findings, [&](const Finding& finding) {
        return finding.severity == Severity::Blocking &&
               (!hasNear(plan.findings, finding, nearM) ||
                blockingOfKind(changed, finding.kind) > blockingOfKind(plan, finding.kind));
    });
}

/// What leaves the field and no change mends is told why, where the field is too narrow.
Result<void> explainNarrowPlaces(Plan& plan, const JobContext& job) {
    if (std::ranges::none_of(plan.findings, leavesUnexplained)) {
        return {};
    }
    return NarrowPlaces::of(plan, job.withoutProgress()).transform([&plan](const NarrowPlaces& places) {
        for (Finding& finding : plan.findings | std::views::filter(leavesUnexplained)) {
            finding.suggestion = places.reasonAt(finding.place);
        }
    });
}

}  // namespace

Result<std::shared_ptr<const Plan>> withAdvice(const std::shared_ptr<const Plan>& plan, const JobContext& job,
                                               StageCache* cache) {
    if (plan->drivable() || plan->request.draft) {
        return plan;
    }
    const double nearM = std::max(kNearM, kNearWidths * plan->request.machine.operatingWidth().si());
    auto advised = std::make_shared<Plan>(*plan);
    const auto needsAdvice = [](const Finding& finding) {
        return finding.severity == Severity::Blocking && !finding.change;
    };
    const std::vector<Change> changes = changesFor(*plan);
    const auto share = [&changes](std::size_t done) {
        return static_cast<double>(done) / static_cast<double>(changes.size());
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        const Change& change = changes[i];
        if (std::ranges::none_of(advised->findings, needsAdvice)) {
            break;
        }
        PlanRequest request = plan->request;
        if (!request.settings.setText(*change.parameter, change.value)) {
            continue;
        }
        // What can be driven stays so with whatever is compared beside.
        request.settings.set(kCompare, std::string{kCompareBlocked}).value();
        const auto changed = makePlan(request, job.part(share(i), share(i + 1)), cache);
        if (!changed && changed.error().code == ErrorCode::Cancelled) {
            return std::unexpected(changed.error());
        }
        if (!changed || isBlockedAnew(**changed, *plan, nearM)) {
            continue;
        }
        for (Finding& finding : advised->findings) {
            if (needsAdvice(finding) && !hasNear((*changed)->findings, finding, nearM)) {
                finding.change = {.key = std::string{change.parameter->key}, .value = change.value};
                finding.suggestion =
                    message("Set \"{}\" to \"{}\": with that this is gone.", change.parameter->name,
                            shownValue(*change.parameter, request.settings.value(*change.parameter)));
            }
        }
    }
    if (const auto explained = explainNarrowPlaces(*advised, job); !explained) {
        return std::unexpected(explained.error());
    }
    return advised;
}

}  // namespace furrow
