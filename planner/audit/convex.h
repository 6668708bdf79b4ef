#pragma once

#include "planner/audit/boundary_index.h"
#include "planner/geometry/polygon.h"

#include <optional>
#include <utility>
#include <vector>

namespace furrow {

// Operations on convex rings. The audit has its own, since it does not trust the planner's.

/// The parts of a ring to the left and to the right of a line. If the ring is not convex, separate parts stay
/// joined by edges without area between them.
std::pair<Ring, Ring> cut(const Ring& ring, Point start, Point along);

/// The convex hull, counter-clockwise.
Ring hullAround(Ring points);

/// The part of a segment, from 0 to 1, that is more than `depthM` inside a convex counter-clockwise ring.
/// Empty if there is none.
std::optional<std::pair<double, double>> partInside(const Ring& hull, const Edge& edge, double depthM = 0.0);

/// The parts of one convex ring outside another, as convex counter-clockwise rings that do not overlap. Both
/// inputs are counter-clockwise.
std::vector<Ring> partsOutside(Ring ring, const Ring& hull);

}  // namespace furrow
