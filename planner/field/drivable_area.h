#pragma once

#include "planner/field/field.h"

namespace furrow {

/// Where tractor and implement may be: the field less `margin` and less the obstacles that may not be driven
/// on, with the gates open. Cancelled. Cost: one GEOS buffer, and a union where there are gates.
Result<MultiPolygon> drivableArea(const Field& field, Length margin, const JobContext& job);

}  // namespace furrow
