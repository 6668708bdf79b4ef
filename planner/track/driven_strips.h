#pragma once

#include "planner/geometry/polygon.h"

namespace furrow {

// Internal to what is worked out from recorded drives.

/// Shorter steps have no direction.
inline constexpr double kShortestStepM = 1e-3;

/// The land beside a line, `halfM` to each side, as pieces that may overlap: a rectangle for each step and
/// the wedge outside of each bend. It ends square, without anything beyond the line's ends. Steps shorter
/// than a millimetre are passed over. Cost: linear.
void addStripsAlong(MultiPolygon& strips, const Polyline& line, double halfM);

}  // namespace furrow
