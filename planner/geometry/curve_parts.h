#pragma once

#include "planner/geometry/curve.h"

#include <vector>

namespace furrow {

/// The part of the line between `from` and `to`, both within its length. Pieces without length are left out.
Curve partOf(const Curve& line, Length from, Length to);

/// The parallel line at this distance to the left (negative: to the right). Preconditions: straights and arcs
/// in forward gear, and no arc to that side has a smaller radius.
Curve movedLeft(const Curve& line, Length left);

/// The line with straight stretches before and after it.
Curve extended(const Curve& line, Length before, Length after);

/// The lines between turns on the spot, those without pieces left out.
std::vector<Curve> betweenTurnsOnTheSpot(const Curve& line);

/// The sharpest bend of the line, not negative.
Curvature sharpestBend(const Curve& line);

}  // namespace furrow
