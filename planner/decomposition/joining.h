#pragma once

#include "planner/core/result.h"
#include "planner/decomposition/cell_cost.h"
#include "planner/decomposition/decomposition.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <vector>

namespace furrow {

/// A border at which one piece continues in another. Both are turned so that the swaths are level.
struct Border {
    double lengthM;
    std::size_t below;
    std::size_t above;
};

/// The borders of level pieces along cuts, the longest first. Cost: O(n²) for n pieces.
std::vector<Border> bordersOf(const MultiPolygon& pieces);

void apply(const Join& join, Groups& groups);

/// Joins two cells at a time, those that lower the cost most, until no join lowers it. Every piece continues
/// into at most one above it and from at most one below. So a line along the heading still meets each cell in
/// one piece. Pieces without swaths join the neighbour with the longest common border. Cancelled. Cost: a few
/// costs for each border.
Result<std::vector<Join>> joinsWhereQuicker(const std::vector<Border>& borders, const CellCost& cost,
                                            std::size_t pieces, const JobContext& job);

}  // namespace furrow
