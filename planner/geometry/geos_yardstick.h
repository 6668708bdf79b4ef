#pragma once

#include "planner/geometry/polygon.h"
#include "planner/units/quantity.h"

namespace furrow {

/// What one heading gives by plain polygon geometry, as others compute it: nothing of it is used for planning.
struct PlainFigures {
    int count = 0;
    Length length;
    double coverage = 0.0;  ///< 0 where it was not asked for
};

/// The fastest plain way with GEOS, on one thread: the polygon's points are turned, one multi-line of all tracks is
/// intersected with it; for the coverage the rectangles of the swaths are united and intersected with it, too.
/// @param withCoverage  otherwise count and length only
PlainFigures plainFigures(const Polygon& mainland, Length width, Angle heading, bool withCoverage);

}  // namespace furrow
