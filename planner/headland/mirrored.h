#pragma once

#include "planner/geometry/polygon.h"
#include "planner/headland/headland.h"
#include "planner/machine/machine.h"
#include "planner/turns/turn.h"

#include <vector>

namespace furrow {

// As seen in a mirror that lies along the x axis: left is right. Mirrored twice, everything is as it was.

/// Outer rings stay counter-clockwise, holes clockwise.
MultiPolygon mirrored(const MultiPolygon& polygons);
/// Its implement is as far to the other side.
Machine mirrored(const Machine& machine);
Turn mirrored(const Turn& turn);
/// The field stays on the left of each.
std::vector<EdgeStrip> mirrored(const std::vector<EdgeStrip>& strips);
/// Driven the other way round.
std::vector<HeadlandPass> mirrored(const std::vector<HeadlandPass>& passes);

}  // namespace furrow
