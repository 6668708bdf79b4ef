#pragma once

#include "planner/field/field.h"

namespace furrow {

/// The area for tractor and implement: the field less `margin` and less the obstacles that may not be driven
/// on, with the gates open. Cancelled. Cost: one GEOS buffer, and a union if there are gates.
Result<MultiPolygon> drivableArea(const Field& field, Length margin, const JobContext& job);

}  // namespace furrow
