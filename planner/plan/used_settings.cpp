#include "planner/plan/used_settings.h"

#include "planner/headland/methods.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/round_stage.h"
#include "planner/route/methods.h"
#include "planner/route/open_strips.h"

#include <algorithm>
#include <vector>

namespace furrow {

namespace {

std::size_t mostOpenStrips(const Plan& plan) {
    std::vector<std::vector<std::size_t>> cells;
    cells.reserve(plan.cells.cells.size());
    for (const Cell& cell : plan.cells.cells) {
        cells.push_back(cell.swaths);
    }
    return OpenStripLimit{0, cells, plan.swaths.swaths.size()}.mostOpen(endOrder(plan.route.steps));
}

}  // namespace

std::optional<double> computedNumber(const Plan& plan, const Parameter& parameter) {
    if (&parameter == &kMargin) {
        return plan.margin.si();
    }
    if (&parameter == &kHeadlandWidth) {
        return plan.headland.width.si();
    }
    if (&parameter == &kHeadlandPasses) {
        return plan.headland.passes;
    }
    if (&parameter == &kRoundUpTo) {
        return roundUpTo(plan.request.settings, plan.request.machine).si();
    }
    const auto& steps = plan.route.steps;
    if (&parameter == &kFirstSwath && !steps.empty()) {
        return plan.swaths.swaths[steps.front().swath].number;
    }
    if (&parameter == &kLastSwath && !steps.empty()) {
        return plan.swaths.swaths[steps.back().swath].number;
    }
    if (&parameter == &kOpenStrips) {
        return static_cast<double>(mostOpenStrips(plan));
    }
    return std::nullopt;
}

SettingValue usedValue(const Plan& plan, const Parameter& parameter) {
    if (const auto change = std::ranges::find(plan.instead, parameter.key, &SettingChange::key);
        change != plan.instead.end()) {
        return change->value;
    }
    if (const auto number = computedNumber(plan, parameter)) {
        return *number;
    }
    return plan.request.settings.value(parameter);
}

}  // namespace furrow
