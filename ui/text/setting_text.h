#pragma once

#include "planner/settings/parameter.h"

#include <QString>

namespace furrow {

/// A setting with the step that it belongs to: "Swaths: Overlap".
QString settingName(const Parameter& parameter);

}  // namespace furrow
