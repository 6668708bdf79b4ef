#pragma once

#include "planner/geometry/polygon.h"

namespace furrow {

/// The line with fewer points. A point stays if the line would otherwise move by more than `tolerance`; first
/// and last always stay (Douglas and Peucker 1973, doi 10.3138/FM57-6770-U75U-7727). Cost: O(n log n) for
/// usual lines, O(n²) at worst.
Polyline simplified(const Polyline& line, Length tolerance);

/// The same for a ring. Its first point stays.
Ring simplifiedRing(Ring ring, Length tolerance);

}  // namespace furrow
