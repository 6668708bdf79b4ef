#include "planner/plan/used_settings.h"

#include "planner/headland/methods.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/round_stage.h"

#include <algorithm>

namespace furrow {

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
