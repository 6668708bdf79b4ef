#pragma once

#include "planner/plan/plan.h"

namespace furrow {

/// The same request with settings for a quick plan, shown while a point is dragged. Swaths keep the heading
/// of the last plan, the headland keeps its width and is not driven, turns are the shortest curves, not
/// eased, and may leave the field, the order is that of the last plan where only the field changed, or else,
/// of many swaths, the best pattern, there are no trips to refill points, and the path is not audited. All
/// other settings stay.
///
/// @param before  the last plan of this field; null if there is none
PlanRequest draftOf(PlanRequest request, const Plan* before);

}  // namespace furrow
