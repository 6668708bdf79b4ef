#pragma once

#include "planner/field/field.h"

namespace furrow {

/// What of a field, holes filled, is not free: with the field's drivable area the obstacles that may not be driven on,
/// with their buffers, and the field's holes. Cost: a GEOS overlay.
Result<MultiPolygon> obstaclesOf(const Field& field, const MultiPolygon& free, const JobContext& job);

/// Where a machine may be that may leave the field: everything in and far around it but what may not be driven on.
/// Cost: a GEOS overlay.
Result<MultiPolygon> groundAround(const Field& field, const JobContext& job);

}  // namespace furrow
