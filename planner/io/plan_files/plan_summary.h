#pragma once

#include "planner/plan/plan.h"

#include <span>
#include <string>

namespace furrow {

/// All figures of a plan as one JSON object, SI units; null for what nothing has measured.
///
/// @param files  what is written of the plan, from its folder; left out where there is none
std::string planSummaryJson(const Plan& plan, std::span<const std::string> files = {});

}  // namespace furrow
