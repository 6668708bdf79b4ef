#pragma once

#include "planner/core/result.h"
#include "planner/route/route.h"

#include <cstddef>
#include <vector>

namespace furrow {

/// InputRefused at a setting of the order.
Error refused(const Parameter& parameter, Message what, Message remedy);

/// The steps that a setting of numbers names: swaths from 1, a minus where one is driven the other way.
/// InputRefused: a number that no swath has, a swath that is named twice.
Result<std::vector<RouteStep>> givenSteps(const Settings& settings, const Parameter& parameter,
                                          std::size_t swathCount);

}  // namespace furrow
