#pragma once

#include "planner/audit/motion.h"

#include <vector>

namespace furrow {

/// For every planned pass, how much of its line is driven with the implement down, from 0 to 1: where the
/// tractor or the implement comes within a quarter of the width. A short pass may so be worked a little
/// before or behind its place, and is still driven. Judged at 20 points, those on land
/// that is left on purpose apart.
/// O(passes * samples of a segment) where segments carry the numbers of their passes.
std::vector<double> drivenShares(const AuditInput& input, const std::vector<SegmentMotion>& motions);

}  // namespace furrow
