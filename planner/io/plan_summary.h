#pragma once

#include "planner/plan/plan.h"

#include <string>

namespace furrow {

/// All figures of a plan as one JSON object, SI units; null for what nothing has measured.
std::string planSummaryJson(const Plan& plan);

}  // namespace furrow
