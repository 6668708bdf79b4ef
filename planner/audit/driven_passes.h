#pragma once

#include "planner/audit/motion.h"

#include <vector>

namespace furrow {

/// For every planned pass, the share of its line that is driven with the implement down, from 0 to 1. A place
/// counts if the tractor or the implement comes within a quarter of the width. So a short pass that is worked
/// a little before or behind its place still counts as driven. 20 points are tested, without those on land
/// that is left on purpose. O(passes * samples of a segment) if segments carry the numbers of their passes.
std::vector<double> drivenShares(const AuditInput& input, const std::vector<SegmentMotion>& motions);

}  // namespace furrow
