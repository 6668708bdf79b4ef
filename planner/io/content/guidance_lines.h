#pragma once

#include "planner/io/content/field_content.h"

namespace furrow {

struct Plan;

/// What terminals are given of the swaths of a plan: a line for each direction and for each set of curves or
/// rings that lie beside each other, which they lay the others beside, and every tramline by itself. Points
/// of curves lie within 2 cm of them. Cost: O(curves * their points).
std::vector<GuidanceLine> guidanceLines(const Plan& plan);

}  // namespace furrow
