#pragma once

#include "planner/field/field.h"

#include <span>
#include <vector>

namespace furrow {

/// Holes and obstacles with their buffers that lie wholly inside a field, may not be driven on, and are
/// nowhere longer than `upTo`. Those that touch each other are one. In metres, clockwise like holes. Cost:
/// O(n log n) for n corners.
std::vector<Ring> smallObstacles(const Field& field, Length upTo);

/// Polygons without these of their holes.
MultiPolygon filled(MultiPolygon polygons, std::span<const Ring> holes);

}  // namespace furrow
