#pragma once

#include "planner/geometry/polygon.h"
#include "planner/units/quantity.h"

namespace furrow {

/// The figures of one heading by plain polygon geometry, as other programs compute it. Not used for planning.
struct PlainFigures {
    int count = 0;
    Length length;
    double coverage = 0.0;  ///< 0 if not requested
};

/// The fastest plain method with GEOS, on one thread. The polygon's points are rotated, and one multi-line of
/// all tracks is intersected with it. For the coverage, the rectangles of the swaths are also united and
/// intersected with it.
/// @param withCoverage  otherwise count and length only
PlainFigures plainFigures(const Polygon& mainland, Length width, Angle heading, bool withCoverage);

}  // namespace furrow
