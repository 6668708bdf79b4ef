#pragma once

#include "planner/plan/stages.h"

#include <functional>
#include <vector>

namespace furrow {

/// Swaths with their ends as the settings want them.
using EndsDrawnOut = std::function<Result<LaidSwaths>(LaidSwaths)>;

/// Gives a cell its own heading if that lowers the estimated time of the whole plan: swaths, turns within
/// cells, ways from cell to cell, and missed land worked piece by piece. Such a cell takes over exactly the
/// land that its lanes of the common heading worked. So nothing beside it is lost or worked twice.
///
/// @param common   swaths in one heading
/// @param pieces   of the mainland, between split lines
/// @param withEnds draws out the ends of swaths, for the estimate
/// @return one part for each piece, and one more for each cell with a heading of its own. Cancelled.
/// Cost: the swath method and one estimate for each cell.
Result<LaidSwaths> withOwnHeadings(const PlanRequest& request, const MultiPolygon& mainland,
                                   const SwathSet& common, const std::vector<MultiPolygon>& pieces,
                                   const EndsDrawnOut& withEnds, const JobContext& job);

}  // namespace furrow
