#pragma once

#include "planner/swaths/heading_search.h"

#include <vector>

namespace furrow {

/// A straight stretch of a boundary.
struct LongEdge {
    Angle heading;  ///< modulo pi, of the line with the best fit
    Length length;
};

/// The long straight edges of a boundary, the longest first. Each is at least `least` long, and at least a
/// fifth of the longest. Edges in a row that stay within 15 cm of one line are one. Cost: O(n log n).
std::vector<LongEdge> longEdges(const MultiPolygon& boundary, Length least);

/// The heading of the longest edge of the mainland, which the method `longest-edge` takes. Of equal edges the
/// first. Where a long edge of the field runs within a degree of it, the heading of that edge: nobody wants
/// to drive a fraction of a degree off the fence. Cost: O(n log n).
Angle longestEdgeHeading(const SwathTask& task);

/// The heading that a search finally takes.
struct PreferredHeading {
    BestHeading chosen;
    std::optional<BestHeading> best;         ///< if an edge with a visibly different heading was preferred
    std::optional<BestHeading> longestEdge;  ///< of a field that has a long edge
};

/// Takes the longest of the field's long edges whose swaths are no worse than those of the best heading.
/// Otherwise takes the best heading. By time and length, the share of `swaths.prefer_edge_percent` may be
/// lost. By number, coverage and overlap nothing may get worse. Except by time no coverage may be lost. Cost:
/// one ScanLine::figures for each long edge.
PreferredHeading preferEdges(const ScanLine& scanLine, const SwathTask& task, SwathObjective objective,
                             const BestHeading& best);

/// The swaths of the preferred heading, with a note about its cost; by time also with the candidates.
/// @param tried  other headings that may become candidates, in any order
Result<SwathSet> swathsOfBest(const ScanLine& scanLine, const SwathTask& task, SwathObjective objective,
                              const BestHeading& best, std::vector<BestHeading> tried, const JobContext& job);

}  // namespace furrow
