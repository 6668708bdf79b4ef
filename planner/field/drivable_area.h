#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/field/field.h"

#include <optional>

namespace furrow {

/// The area for everything: the field less `margin` and less the obstacles that may not be driven
/// on, with the gates open. Cancelled. Cost: one GEOS buffer, and a union if there are gates.
Result<MultiPolygon> drivableArea(const Field& field, Length margin, const JobContext& job);

/// The same for tractor and implement apart. The margin and the gates hold for both.
/// @param overhung  from overhungLand
Result<AllowedAreas> allowedAreas(const Field& field, const std::optional<MultiPolygon>& overhung,
                                  Length margin, const JobContext& job);

}  // namespace furrow
