#pragma once

#include "planner/machine/machine.h"
#include "planner/path/path_builder.h"

#include <span>

namespace furrow {

/// Samples successive legs and gives every sample its speed and time. The result is the fastest drive within
/// the limits, from one pass forwards (acceleration) and one backwards (braking). Source of the two passes:
/// Shin & McKay 1985, doi 10.1109/TAC.1985.1104009. Cost: O(samples).
Path withSpeeds(std::span<const Leg> legs, const Machine& machine);

}  // namespace furrow
