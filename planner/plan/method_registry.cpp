#include "planner/plan/method_registry.h"

#include "planner/headland/methods.h"
#include "planner/path/gate_ways.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/round_stage.h"
#include "planner/route/methods.h"
#include "planner/settings/operation.h"
#include "planner/settings/traversal.h"
#include "planner/swaths/methods.h"
#include "planner/swaths/short_swaths.h"
#include "planner/swaths/tramlines.h"
#include "planner/turns/methods.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace furrow {

namespace {

// Parameters that every method of a stage reads.
constexpr std::array<const Parameter*, 7> kSwathParameters{
    &kEnds, &kOverlap, &kLastPass, &kMinLength, &kTramlineEvery, &kTramlineStart, &kRoundUpTo};
constexpr std::array<const Parameter*, 2> kCellParameters{&kSplit, &kCellHeading};
constexpr std::array<const Parameter*, 5> kRouteParameters{&kTraversal, &kRouteStart, &kRouteEnd,
                                                           &kRouteRefill, &kCompare};
constexpr std::array<const Parameter*, 1> kPathParameters{&kStayInside};
constexpr std::array<const Parameter*, 3> kGeneralParameters{&kOperationKind, &kMargin, &kOverhang};

template <class Methods>
std::vector<Choice> choicesFrom(const Methods& methods) {
    std::vector<Choice> choices;
    choices.reserve(methods.size());
    for (const auto* method : methods) {
        choices.push_back({method->info.id, method->info.name, method->info.description});
    }
    return choices;
}

/// A stage, built once from its list of methods; the method itself is a setting like any other.
struct StageEntry {
    template <class Methods>
    StageEntry(const Methods& methods, std::string_view id, std::string_view stageName, std::string_view key,
               std::string_view name, std::string_view description,
               std::span<const Parameter* const> parameters)
        : choices{choicesFrom(methods)},
          method{.key = key,
                 .name = name,
                 .description = description,
                 .kind = ParameterKind::Choice,
                 .standard = 0.0,
                 .choices = choices} {
        info = {.id = id, .name = stageName, .method = &method, .methods = {}, .parameters = parameters};
        for (const auto* entry : methods) {
            info.methods.push_back(entry->info);
        }
    }
    StageEntry(const StageEntry&) = delete;
    StageEntry& operator=(const StageEntry&) = delete;

    std::vector<Choice> choices;
    Parameter method;
    StageInfo info;
};

struct Registry {
    StageEntry headland{kHeadlandMethods,
                        "headland",
                        "Headland",
                        "headland.method",
                        "Headland",
                        "The strip kept for turning.",
                        {}};
    StageEntry swaths{kSwathMethods,   "swaths",  "Swaths",
                      "swaths.method", "Heading", "How the direction of the swaths is found.",
                      kSwathParameters};
    StageEntry decomposition{kDecompositionMethods,
                             "decomposition",
                             "Blocks",
                             "decomposition.method",
                             "Blocks",
                             "How the field is divided; the swaths of a block are driven together.",
                             kCellParameters};
    StageEntry route{kRouteMethods,   "route", "Route",
                     "route.method",  "Order", "In which order the swaths are driven.",
                     kRouteParameters};
    StageEntry path{kTurnMethods,   "path", "Turns",
                    "path.method",  "Turn", "How the machine gets from one swath to the next.",
                    kPathParameters};
    std::vector<StageInfo> stages{headland.info, swaths.info, decomposition.info, route.info, path.info};
    std::vector<const Parameter*> parameters;

    Registry() {
        const auto add = [this](std::span<const Parameter* const> more) {
            for (const Parameter* parameter : more) {
                if (std::ranges::find(parameters, parameter) == parameters.end()) {
                    parameters.push_back(parameter);
                }
            }
        };
        add(kGeneralParameters);
        for (const StageInfo& stage : stages) {
            add({&stage.method, 1});
            for (const MethodInfo& method : stage.methods) {
                add(method.parameters);
            }
            add(stage.parameters);
        }
    }
};

const Registry& registry() {
    static const Registry instance;
    return instance;
}

template <class Methods>
const auto& chosenMethod(const Methods& methods, const StageEntry& stage, const Settings& settings) {
    const std::string id = settings.choice(stage.method);
    return **std::ranges::find(methods, id, [](const auto* method) { return method->info.id; });
}

}  // namespace

const Parameter kMargin{
    .key = "field.margin_m",
    .name = "Margin",
    .description = "Distance from the boundary that nothing enters; auto is the boundary's accuracy.",
    .kind = ParameterKind::Length,
    .standard = {},
    .canBeAuto = true,
    .min = 0.0,
    .max = 50.0,
    .step = 0.1,
    .choices = {}};

const Parameter kOverhang{
    .key = "field.overhang_m",
    .name = "Overhang",
    .description =
        "How far the implement may stand over the boundary and obstacles, its sections there switched off; the tractor and all wheels stay inside.",
    .kind = ParameterKind::Length,
    .standard = 0.0,
    .min = 0.0,
    .max = 100.0,
    .step = 0.5,
    .choices = {}};

const Parameter kStayInside{.key = "path.stay_inside",
                            .name = "Stay inside",
                            .description = "Check that the machine stays inside the field while it turns.",
                            .kind = ParameterKind::Flag,
                            .standard = 1.0,
                            .choices = {}};

std::span<const StageInfo> stages() {
    return registry().stages;
}

const StageInfo& stageInfo(std::string_view stageId) {
    return *std::ranges::find(registry().stages, stageId, &StageInfo::id);
}

const Parameter* stageMethod(std::string_view stageId) {
    return stageInfo(stageId).method;
}

std::span<const Parameter* const> generalParameters() {
    return kGeneralParameters;
}

std::span<const Parameter* const> allParameters() {
    return registry().parameters;
}

Result<const Parameter*> findParameter(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const Parameter* parameter : allParameters()) {
        if (parameter->key == key) {
            return parameter;
        }
        keys.push_back(parameter->key);
    }
    const std::string nearest = nearestName(key, keys);
    return std::unexpected(Error{.code = ErrorCode::Usage,
                                 .what = message("there is no setting '{}'", key),
                                 .where = "settings",
                                 .remedy = nearest.empty() ? "furrow-cli list methods shows all of them"
                                                           : message("did you mean '{}'?", nearest)});
}

Result<void> applySetting(Settings& settings, std::string_view key, std::string_view text) {
    return findParameter(key).and_then(
        [&](const Parameter* found) { return settings.setText(*found, text); });
}

const Method<HeadlandGenerator>& headlandMethod(const Settings& settings) {
    return chosenMethod(kHeadlandMethods, registry().headland, settings);
}

const Method<SwathGenerator>& swathMethod(const Settings& settings) {
    return chosenMethod(kSwathMethods, registry().swaths, settings);
}

const Method<Decomposer>& decompositionMethod(const Settings& settings) {
    return chosenMethod(kDecompositionMethods, registry().decomposition, settings);
}

const Method<RoutePlanner>& routeMethod(const Settings& settings) {
    return chosenMethod(kRouteMethods, registry().route, settings);
}

const Method<TurnPlanner>& turnMethod(const Settings& settings) {
    return chosenMethod(kTurnMethods, registry().path, settings);
}

std::vector<const Method<RoutePlanner>*> routePatterns() {
    std::vector<const Method<RoutePlanner>*> patterns;
    std::ranges::copy_if(kRouteMethods, std::back_inserter(patterns), [](const auto* method) {
        return !method->traits.isByTime && !method->traits.isByHand;
    });
    return patterns;
}

}  // namespace furrow
