#pragma once

#include "planner/swaths/swath.h"

namespace furrow {

/// The strips along the right and left edge of a mainland that the last pass leaves out. They lie to the
/// right of the first lane and to the left of the last one, and are `restRight` and `restLeft` wide. Land at
/// the ends of swaths does not count. Straight swaths only. Cancelled. Cost: two GEOS intersections; none if
/// both are under a millimetre.
Result<MultiPolygon> besideLanes(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job);

/// The land between and beside the lanes of a set. A lane continues straight from both ends of its swath
/// until it leaves the mainland, so land at the ends does not count. Cancelled. Cost: one GEOS intersection
/// for each end.
Result<MultiPolygon> betweenLanes(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job);

/// The same, but only pieces that lie beside the first track alone, or the last track alone. Cancelled.
Result<MultiPolygon> besideOutermostLanes(const SwathSet& set, const MultiPolygon& mainland,
                                          const JobContext& job);

}  // namespace furrow
