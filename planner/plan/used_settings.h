#pragma once

#include "planner/plan/plan.h"

#include <optional>

namespace furrow {

/// The number that the planner computed for a setting that may be "auto". Empty for settings that have none.
std::optional<double> computedNumber(const Plan& plan, const Parameter& parameter);

/// The value of a setting that a plan was made with: computed for "auto", decided by the planner, or as
/// asked.
SettingValue usedValue(const Plan& plan, const Parameter& parameter);

}  // namespace furrow
