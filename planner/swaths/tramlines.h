#pragma once

#include "planner/swaths/swath.h"

namespace furrow {

/// Every n-th swath is a tramline; 0 for none.
extern const Parameter kTramlineEvery;
/// The place of the first one.
extern const Parameter kTramlineStart;

/// Marks every n-th track as a tramline, as set in the settings. Without a given line the tracks are counted
/// from the left or right edge of the mainland (left along the heading). With `half`, a machine n widths wide
/// begins flush at the left edge or, for even n, half a width beyond it. Tracks with a lane count from the
/// given line instead, which is itself a tramline (with `half` it lies between two). These tramlines are the
/// same every season, even if the boundary changes. Swaths that were moved off their lane to the edge are no
/// tramlines.
void markTramlines(SwathSet& set, const Settings& settings);

}  // namespace furrow
