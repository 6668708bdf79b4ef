#pragma once

#include "planner/swaths/heading_search.h"

#include <vector>

namespace furrow {

/// A straight stretch of a boundary.
struct LongEdge {
    Angle heading;  ///< modulo pi, of the line that fits it best
    Length length;
};

/// The long straight edges of a boundary, the longest first: those at least `least` and a fifth of the longest one long.
/// Edges in a row that stay within 15 cm of one line are one. Cost: O(n log n).
std::vector<LongEdge> longEdges(const MultiPolygon& boundary, Length least);

/// Of the longest edge of a mainland, which the method `longest-edge` takes; of equally long ones the first. Cost: O(n).
Angle longestEdgeHeading(const MultiPolygon& mainland);

/// What a search takes in the end.
struct PreferredHeading {
    BestHeading chosen;
    std::optional<BestHeading> best;         ///< that an edge was preferred to, where that can be seen
    std::optional<BestHeading> longestEdge;  ///< of a field that has a long edge
};

/// Of the field's long edges the longest one along which swaths are no worse than with the best heading, but for the
/// share of `swaths.prefer_edge_percent`; otherwise the best heading itself. By time and length that share is allowed;
/// by number, coverage and overlap nothing may get worse; and except by time no coverage may be lost.
/// Cost: one ScanLine::figures for each long edge.
PreferredHeading preferEdges(const ScanLine& scanLine, const SwathTask& task, SwathObjective objective, const BestHeading& best);

/// The swaths of the heading that is preferred, with a note that says what it costs; by time with the candidates.
/// @param tried  other headings that may become candidates, in any order
Result<SwathSet> swathsOfBest(const ScanLine& scanLine, const SwathTask& task, SwathObjective objective, const BestHeading& best,
                              std::vector<BestHeading> tried, const JobContext& job);

}  // namespace furrow
