#pragma once

#include "planner/field/field.h"

namespace furrow {

/// The obstacles that may not be driven on, with their buffers, and the field's holes. Cost: a GEOS overlay.
Result<MultiPolygon> obstaclesOf(const Field& field, const JobContext& job);

/// Where a machine may be that may leave the field: everything in and far around it but these obstacles.
Result<MultiPolygon> groundAround(const Field& field, const MultiPolygon& obstacles, const JobContext& job);

}  // namespace furrow
