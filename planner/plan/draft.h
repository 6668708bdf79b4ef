#pragma once

#include "planner/plan/plan.h"

namespace furrow {

/// The same request with settings that take a small part of the time: for a plan that is only looked at, as
/// while a point is dragged. Swaths keep the heading of the plan before instead of searching one, the
/// headland keeps its width and is not driven, turns are the shortest curves and may leave the field, and the
/// path is not measured. What the user has chosen beyond that stays.
///
/// @param before  the last plan of this field; null for none
PlanRequest draftOf(PlanRequest request, const Plan* before);

}  // namespace furrow
