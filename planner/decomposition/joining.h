#pragma once

#include "planner/core/result.h"
#include "planner/decomposition/cell_cost.h"
#include "planner/decomposition/decomposition.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <vector>

namespace furrow {

/// Where one piece goes on in another, both turned so that the swaths are level.
struct Border {
    double lengthM;
    std::size_t below;
    std::size_t above;
};

/// Of level pieces that cuts have left, the longest first. Cost: O(n²) for n pieces.
std::vector<Border> bordersOf(const MultiPolygon& pieces);

void apply(const Join& join, Groups& groups);

/// Joins, one after the other, the two cells of which that lowers the cost most, until it lowers it nowhere. Every
/// piece goes on into at most one above it and out of at most one below: a line along the heading still meets each
/// cell in one piece. Pieces without swaths go to the neighbour that they share most of their border with.
/// Cancelled. Cost: a few costs for each border.
Result<std::vector<Join>> joinsWhereQuicker(const std::vector<Border>& borders, const CellCost& cost, std::size_t pieces,
                                            const JobContext& job);

}  // namespace furrow
