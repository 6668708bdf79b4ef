#pragma once

#include "planner/field/field.h"

namespace furrow {

/// The part of a field (holes filled) that is not in `free`. If `free` is the field's drivable area, these
/// are the obstacles that may not be driven on, with their buffers, and the field's holes. Cost: a GEOS
/// overlay.
Result<MultiPolygon> obstaclesOf(const Field& field, const MultiPolygon& free, const JobContext& job);

/// The area for a machine that may leave the field: everything in and far around it, except obstacles that
/// may not be driven on. Cost: a GEOS overlay.
Result<MultiPolygon> groundAround(const Field& field, const JobContext& job);

}  // namespace furrow
