#pragma once

#include "planner/field/field.h"

#include <span>
#include <vector>

namespace furrow {

/// What lies wholly inside a field, may not be driven on and is nowhere longer than this: holes and obstacles with
/// their buffers, those that touch each other as one. In metres, clockwise as holes are.
/// Cost: O(n log n) for n corners.
std::vector<Ring> smallObstacles(const Field& field, Length upTo);

/// Polygons without these of their holes.
MultiPolygon filled(MultiPolygon polygons, std::span<const Ring> holes);

}  // namespace furrow
