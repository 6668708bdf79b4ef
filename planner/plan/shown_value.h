#pragma once

#include "planner/core/message.h"
#include "planner/settings/parameter.h"

#include <string_view>

namespace furrow {

/// A setting's value as people see it.
Message shownValue(const Parameter& parameter, const SettingValue& value);

}  // namespace furrow
