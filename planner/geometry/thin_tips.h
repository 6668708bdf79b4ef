#pragma once

#include "planner/geometry/polygon.h"

namespace furrow {

/// A polygon without the tips of its spikes, as far as they are narrower than a width. A disc of radius r
/// inside of the polygon reaches into what is taken off by width² / 8r at most: wider things than discs do
/// not tell the two apart.
///
///     p ________               p ____
///       ________>  i             ____|  c        |p c| <= width
///     q                        q
///
/// @param polygon  outer ring counter-clockwise, holes clockwise; valid
/// @return the same rings, maybe fewer of them. Where something else lies within a spike, a ring may cross
/// it. Cost: O(n).
Polygon withoutThinTips(const Polygon& polygon, Length width);

}  // namespace furrow
