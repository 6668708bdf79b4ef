#pragma once

#include "planner/swaths/swath.h"

namespace furrow {

/// Of a mainland with straight swaths, the strips along its right and left edge that the last pass leaves out: all that
/// is to the right of the first or to the left of the last lane of the set, by `restRight` and `restLeft`. Land at the
/// ends of swaths is none of it. Cancelled. Cost: two GEOS intersections; none where both are under a millimetre.
Result<MultiPolygon> besideLanes(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job);

/// What no lane of a set covers, between and beside them. A lane goes straight on from both ends of its swath until it
/// leaves the mainland, so that land at the ends is none of it. Cancelled. Cost: one GEOS intersection for each end.
Result<MultiPolygon> betweenLanes(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job);

/// Of what lies between and beside lanes, the pieces that only the first track, or only the last, is next to. Cancelled.
Result<MultiPolygon> besideOutermostLanes(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job);

}  // namespace furrow
