#include "planner/io/plan_files/plan_summary.h"

#include "planner/headland/methods.h"
#include "planner/io/plan_files/audit_json.h"
#include "planner/machine/machine_file.h"
#include "planner/path/folded_stretches.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/round_stage.h"
#include "planner/plan/used_settings.h"
#include "planner/route/route_costs.h"
#include "planner/settings/operation.h"
#include "planner/version.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace furrow {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson valueJson(const Parameter& parameter, const SettingValue& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return parameter.kind == ParameterKind::Count ? OrderedJson(static_cast<int>(*number))
                                                      : OrderedJson(*number);
    }
    if (const auto* flag = std::get_if<bool>(&value)) {
        return *flag;
    }
    return settingText(value);
}

OrderedJson settingJson(const Parameter& parameter, const Settings& settings) {
    return parameter.kind == ParameterKind::Numbers ? OrderedJson(settings.numbers(parameter))
                                                    : valueJson(parameter, settings.value(parameter));
}

/// Every setting with the value that was used, also where that was computed.
OrderedJson settingsJson(const Plan& plan) {
    OrderedJson all = OrderedJson::object();
    for (const Parameter* parameter : allParameters()) {
        all[parameter->key] = parameter->kind == ParameterKind::Numbers
                                  ? OrderedJson(plan.request.settings.numbers(*parameter))
                                  : valueJson(*parameter, usedValue(plan, *parameter));
    }
    return all;
}

/// What was asked for and not taken, since something simpler is quicker.
OrderedJson askedJson(const Plan& plan) {
    OrderedJson asked = OrderedJson::object();
    for (const SettingChange& change : plan.instead) {
        asked[change.key] = settingJson(**findParameter(change.key), plan.request.settings);
    }
    return asked;
}

/// What the operation set: those of its settings that were not given.
OrderedJson operationSets(const Settings& settings) {
    OrderedJson sets = OrderedJson::object();
    for (const OperationDefault& entry : settings.operation().defaults) {
        if (const Parameter* const parameter = findParameter(entry.key).value();
            !settings.isSet(*parameter)) {
            sets[entry.key] = settingJson(*parameter, settings);
        }
    }
    return sets;
}

std::string methodOf(std::string_view stageId, const Settings& settings) {
    return settings.choice(*stageMethod(stageId));
}

/// One for each cell.
OrderedJson headingsJson(const Decomposition& cells) {
    OrderedJson headings = OrderedJson::array();
    for (const Cell& cell : cells.cells) {
        headings.push_back(inDegrees(cell.heading));
    }
    return headings;
}

/// Costs are estimated in free space; where nothing was estimated, as for one piece, there are none.
OrderedJson decompositionJson(const Decomposition& cells) {
    const std::vector<DecompositionStep>& steps = cells.history.steps;
    OrderedJson json{{"cells", cells.cells.size()},
                     {"cells_before", steps.empty() ? cells.cells.size() : steps.front().cells},
                     {"altitude_m", cells.altitude.si()}};
    if (!steps.empty()) {
        json["cost_before_s"] = steps.front().cost.si();
        json["cost_after_s"] = steps.back().cost.si();
    }
    return json;
}

OrderedJson milliseconds(Duration duration) {
    return duration.si() * 1e3;
}

OrderedJson swathsJson(const Plan& plan) {
    return {{"count", plan.swaths.swaths.size()},
            {"total_length_m", plan.swaths.totalLength.si()},
            {"heading_deg", headingsJson(plan.cells)},
            {"proved", plan.swaths.proved},
            {"coverage", plan.swaths.coverage},
            {"overlap_m2", plan.swaths.overlap.si()},
            {"shift_m", plan.swaths.shift.si()},
            {"end_overlap_m2", plan.swaths.endOverlap.si()},
            {"round_up_to_m", roundUpTo(plan.request.settings, plan.request.machine).si()},
            {"obstacles_gone_round", plan.swaths.goneRound.size()}};
}

OrderedJson pathJson(const Plan& plan) {
    OrderedJson json{{"length_m", plan.path.length().si()},
                     {"working_length_m", plan.path.workedLength().si()},
                     {"turn_length_m", plan.path.length(SegmentKind::Turn).si()},
                     {"transfer_length_m", plan.path.length(SegmentKind::Transfer).si()},
                     {"reverse_length_m", plan.path.reversedLength().si()},
                     {"time_s", plan.path.duration().si()},
                     {"turns", plan.path.turnCount()},
                     {"undrivable_turns", plan.path.undrivableCount()}};
    if (const auto folded = foldedStretches(plan.path.segments); !folded.empty()) {
        json["folded_ways"] = folded.size();
        json["folding_time_s"] = foldingTime(plan.path.segments, plan.request.machine).si();
    }
    if (plan.refill) {
        const int refills = plan.path.refillCount();
        json["refills"] = refills;
        json["refill_length_m"] = plan.path.length(SegmentKind::Refill).si();
        json["refill_time_s"] = refills * plan.request.machine.spec().tank->fillTime().si();
    }
    return json;
}

/// Cost and bound are of swaths, turns and ways between swaths where the order was left to the planner, and
/// the time of the whole path elsewhere.
OrderedJson routeJson(const Plan& plan) {
    OrderedJson route{{"method", methodOf("route", plan.request.settings)},
                      {"length_in_place_m", plan.route.lengthInPlace.si()}};
    if (plan.proof) {
        route["objective"] = plan.request.settings.choice(kRouteObjective);
        route["cost"] = plan.proof->working + plan.proof->nonWorking;
        route["non_working_cost"] = plan.proof->nonWorking;
        route["lower_bound"] = plan.proof->lowerBound;
        route["gap"] = plan.proof->gap();
        route["gap_total"] = plan.proof->gapTotal();
    } else {
        route["cost"] = plan.path.duration().si();
        route["non_working_cost"] = (plan.path.duration() - plan.path.workedDuration()).si();
        route["gap"] = nullptr;
        route["gap_total"] = nullptr;
    }
    return route;
}

/// Times with the time to work separately what the plan misses.
OrderedJson choicesJson(const ChoiceTable& table) {
    const auto changesOf = [](const TriedChoice& tried) {
        OrderedJson changes = OrderedJson::object();
        for (const SettingChange& change : tried.changes) {
            changes[change.key] = change.value.empty() ? OrderedJson(nullptr) : OrderedJson(change.value);
        }
        return changes;
    };
    OrderedJson taken = OrderedJson::array();
    OrderedJson others = OrderedJson::array();
    for (const TriedChoice& tried : table.tried) {
        OrderedJson json{{"choice", tried.choice}, {"settings", changesOf(tried)}};
        if (tried.worth == TriedChoice::Worth::Taken) {
            json["saves_s"] = tried.difference.si();
            taken.push_back(std::move(json));
        } else {
            json["slower_s"] = tried.worth == TriedChoice::Worth::Slower ? OrderedJson(tried.difference.si())
                                                                         : OrderedJson(nullptr);
            others.push_back(std::move(json));
        }
    }
    return {{"time_asked_s", table.asked.si()}, {"problems_asked", table.askedProblems},
            {"time_s", table.best.si()},        {"alternatives", table.alternatives},
            {"taken", std::move(taken)},        {"others", std::move(others)}};
}

}  // namespace

std::string planSummaryJson(const Plan& plan, std::span<const std::string> files) {
    const Settings& settings = plan.request.settings;
    const OrderedJson machine = OrderedJson::parse(machineJson(plan.request.machine.spec()));
    OrderedJson summary{
        {"field",
         {{"id", plan.field().id()},
          {"name", plan.field().name()},
          {"area_m2", plan.field().area().si()},
          {"vertices", plan.field().vertexCount()},
          {"holes", plan.field().holeCount()}}},
        {"crs", plan.field().frame().projString()},
        {"machine", machine},
        {"machines", OrderedJson::array({machine})},
        {"operation", settings.choice(kOperationKind)},
        {"operation_sets", operationSets(settings)},
        {"tank", tankUseId(settings.operation().tank)},
        {"settings", settingsJson(plan)},
        {"settings_asked", askedJson(plan)},
        {"headland",
         {{"width_m", plan.headland.width.si()},
          {"passes", plan.headland.passes},
          {"rings", plan.headland.drivenPasses.size()},
          {"uncut_strip_m", plan.headland.uncutStrip.si()},
          {"uncut_corners_m2", plan.headland.uncutCorners.si()},
          {"mainland_ratio", plan.headland.mainlandRatio}}},
        {"decomposition", decompositionJson(plan.cells)},
        {"swaths", swathsJson(plan)},
        {"route", routeJson(plan)},
        {"path", pathJson(plan)},
        {"drivable", plan.drivable()},
        {"audit", OrderedJson::parse(auditJson(plan.audit, plan.findings, plan.field().frame()))},
        {"timing_ms",
         {{"headland", milliseconds(plan.timings.headland)},
          {"swaths", milliseconds(plan.timings.swaths)},
          {"route", milliseconds(plan.timings.route)},
          {"path", milliseconds(plan.timings.path)},
          {"audit", milliseconds(plan.timings.audit)},
          {"proof", milliseconds(plan.timings.proof)},
          {"total", milliseconds(plan.timings.total)}}},
        {"version", kVersion}};
    if (plan.choices) {
        summary["best"] = choicesJson(*plan.choices);
    }
    if (!files.empty()) {
        summary["files"] = std::vector<std::string>{files.begin(), files.end()};
    }
    return summary.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace furrow
