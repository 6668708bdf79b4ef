#pragma once

#include "planner/plan/stages.h"

#include <functional>
#include <vector>

namespace furrow {

/// Swaths with their ends as the settings want them.
using EndsDrawnOut = std::function<Result<LaidSwaths>(LaidSwaths)>;

/// Gives cells a heading of their own where that lowers the estimated time of the whole: swaths, turns within
/// cells, ways from cell to cell, and what is missed worked piecemeal. A cell with a heading of its own takes
/// over the land that only its lanes of the common heading worked, no more and no less, so that nothing is
/// lost or worked twice beside it.
///
/// @param common   swaths in one heading
/// @param pieces   of the mainland, between split lines
/// @param withEnds draws out ends, for the estimate
/// @return one part for each piece, and one more for each cell with a heading of its own. Cancelled.
/// Cost: the swath method and one estimate for each cell.
Result<LaidSwaths> withOwnHeadings(const PlanRequest& request, const MultiPolygon& mainland,
                                   const SwathSet& common, const std::vector<MultiPolygon>& pieces,
                                   const EndsDrawnOut& withEnds, const JobContext& job);

}  // namespace furrow
