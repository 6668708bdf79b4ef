#pragma once

#include "planner/audit/boundary_index.h"
#include "planner/geometry/polygon.h"

#include <optional>
#include <utility>
#include <vector>

namespace furrow {

// What the audit asks of convex rings; the planner's own answers are not trusted here.

/// The parts of a ring to the left and to the right of a line. Of a ring that is not convex, parts that come apart
/// stay joined by edges with nothing between them.
std::pair<Ring, Ring> cut(const Ring& ring, Point start, Point along);

/// Counter-clockwise.
Ring hullAround(Ring points);

/// The part of a segment, from 0 to 1, that is inside a convex counter-clockwise ring by more than
/// `depthM`; nothing where none is.
std::optional<std::pair<double, double>> partInside(const Ring& hull, const Edge& edge, double depthM = 0.0);

/// What of one convex ring lies outside another, as convex rings that do not overlap, counter-clockwise as
/// both of them are.
std::vector<Ring> partsOutside(Ring ring, const Ring& hull);

}  // namespace furrow
