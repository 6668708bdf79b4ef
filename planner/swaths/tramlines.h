#pragma once

#include "planner/swaths/swath.h"

namespace furrow {

/// Every how many swaths there is a tramline; 0 for none.
extern const Parameter kTramlineEvery;
/// Where the first one is.
extern const Parameter kTramlineStart;

/// Marks every n-th track as a tramline, as the settings have it. Without a line of one's own the tracks are counted
/// from the left or right edge of the mainland (left along the heading), with `half` so that a machine n widths wide
/// begins flush at the left edge or, where n is even, half a width beyond it. Tracks that have a lane count from the
/// line that was given instead, which is a tramline itself (with `half`: lies between two): the same ones every season,
/// whatever becomes of the boundary. Swaths that were moved off their lane to the edge are no tramlines.
void markTramlines(SwathSet& set, const Settings& settings);

}  // namespace furrow
