#pragma once

#include "planner/headland/headland.h"
#include "planner/plan/plan.h"
#include "planner/route/route.h"
#include "planner/settings/method.h"
#include "planner/settings/parameter.h"
#include "planner/swaths/swath.h"
#include "planner/turns/turn_method.h"

#include <span>
#include <string_view>
#include <vector>

namespace furrow {

/// One stage of the pipeline with its methods; the first method is the default.
struct StageInfo {
    std::string_view id;      ///< "headland", "swaths", "decomposition", "route", "path"
    std::string_view name;    ///< "Headland"
    const Parameter* method;  ///< the setting that picks the method
    std::vector<MethodInfo> methods;
    std::span<const Parameter* const> parameters;  ///< those that every method of the stage reads
};

/// All stages in the order of the pipeline: the one list that window, command line and benchmarks read.
std::span<const StageInfo> stages();

/// A stage; there has to be one with this id.
const StageInfo& stageInfo(std::string_view stageId);

/// The setting that chooses its method.
const Parameter* stageMethod(std::string_view stageId);

/// Settings that belong to no stage: operation, margin.
std::span<const Parameter* const> generalParameters();

/// Every parameter there is, each once.
std::span<const Parameter* const> allParameters();

/// Usage: no such key (the message names the nearest one).
Result<const Parameter*> findParameter(std::string_view key);

/// Sets `key` from text. Errors as Settings::setText and findParameter.
Result<void> applySetting(Settings& settings, std::string_view key, std::string_view text);

/// The methods that a request has chosen. The settings hold only names that exist.
const Method<HeadlandGenerator>& headlandMethod(const Settings& settings);
const Method<SwathGenerator>& swathMethod(const Settings& settings);
const Method<Decomposer>& decompositionMethod(const Settings& settings);
const Method<RoutePlanner>& routeMethod(const Settings& settings);
const Method<TurnPlanner>& turnMethod(const Settings& settings);

/// The orders of swaths that follow a pattern. Plain ones are those that every driver knows, with few long
/// ways.
std::vector<const Method<RoutePlanner>*> routePatterns();

}  // namespace furrow
