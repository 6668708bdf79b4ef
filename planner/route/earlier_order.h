#pragma once

#include "planner/route/driven_swath.h"
#include "planner/route/link_costs.h"

#include <span>

namespace furrow {

/// An order of these swaths that follows the order of an earlier plan of about the same field: each takes the
/// place and the direction of the earlier swath that it lies on, or lies next to. Straight swaths may have
/// moved aside together. Several at one earlier swath follow each other, the pieces of one track in the same
/// direction, a track beside it in the opposite one. No order: without earlier swaths, with more than
/// kMostSearched on either side, or where a swath was turned by more than 20 degrees.
/// Cost: O(swaths times earlier swaths).
EndOrder orderAsBefore(const SwathSet& swaths, std::span<const DrivenSwath> earlier);

}  // namespace furrow
