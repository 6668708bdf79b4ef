#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/geometry/curve.h"
#include "planner/geometry/polygon.h"
#include "planner/headland/headland.h"
#include "planner/machine/machine.h"

#include <vector>

namespace furrow {

// Reflected in the x axis: left becomes right. Reflecting twice restores the original.

/// Outer rings stay counter-clockwise, holes clockwise.
MultiPolygon mirrored(const MultiPolygon& polygons);
AllowedAreas mirrored(const AllowedAreas& areas);
/// The lateral offset of its implement changes its sign.
Machine mirrored(const Machine& machine);
Curve mirrored(const Curve& turn);
/// The field stays on the left of each.
std::vector<EdgeStrip> mirrored(const std::vector<EdgeStrip>& strips);
/// Driven in the other direction.
std::vector<HeadlandPass> mirrored(const std::vector<HeadlandPass>& passes);

}  // namespace furrow
