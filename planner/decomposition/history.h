#pragma once

#include "planner/decomposition/cell_cost.h"
#include "planner/decomposition/decomposition.h"

#include <vector>

namespace furrow {

/// The cell of each piece after a step.
Groups cellsAt(const DecompositionHistory& history, std::size_t step);

/// The outlines of all cells after a step, in the order of their first pieces. Cancelled. Cost: a GEOS union
/// for each cell of several pieces.
Result<std::vector<MultiPolygon>> outlinesAt(const DecompositionHistory& history, std::size_t step,
                                             const JobContext& job);

/// The outlines of the two cells that became one in a step that lowered the cost. Empty for other steps.
/// Cancelled.
Result<std::vector<MultiPolygon>> joinedAt(const DecompositionHistory& history, std::size_t step,
                                           const JobContext& job);

/// The outlines of the cells that the pieces form, in the order of their first pieces. Cancelled.
Result<std::vector<MultiPolygon>> outlinesOf(const MultiPolygon& pieces, const Groups& groups,
                                             const JobContext& job);

}  // namespace furrow
