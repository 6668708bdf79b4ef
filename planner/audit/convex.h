#pragma once

#include "planner/audit/boundary_index.h"
#include "planner/geometry/polygon.h"

#include <optional>
#include <utility>

namespace furrow {

// What the audit asks of convex rings; the planner's own answers are not trusted here.

/// Counter-clockwise.
Ring hullAround(Ring points);

/// The part of a segment, from 0 to 1, that is inside a convex counter-clockwise ring by more than
/// `depthM`; nothing where none is.
std::optional<std::pair<double, double>> partInside(const Ring& hull, const Edge& edge, double depthM = 0.0);

}  // namespace furrow
