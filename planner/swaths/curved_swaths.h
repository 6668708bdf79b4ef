#pragma once

#include "planner/swaths/guide_line.h"
#include "planner/swaths/mainland_edges.h"
#include "planner/swaths/scan_line.h"
#include "planner/swaths/strip_coverage.h"

#include <vector>

namespace furrow {

/// The smallest radius that the middle of a swath may have: the machine's, and what its implement sits to the side.
Length swathRadius(const Machine& machine);

/// A line to work along, inside the mainland.
struct SwathLine {
    int track = 0;
    Turn line;
    std::optional<int> lane = {};
};

/// Where tracks lie, in metres to the left of a reference, rising: over a mainland that reaches from `lowM` to
/// `highM`.
/// @param anchored  one of them at 0 where that is inside, the others whole steps from it, as with an AB line;
///                  otherwise the first is flush with the lower edge
std::vector<double> trackPlaces(double lowM, double highM, const SwathSpacing& spacing, bool anchored);

/// The parallels of a guide line over all of the mainland, cut to it, spaced and anchored as above. Parts that are shorter than
/// one operating width are left out where they are remains of a bend. Cancelled. InputRefused: over a million tracks.
Result<std::vector<SwathLine>> parallelSwathLines(const GuideLine& guide, const SwathSpacing& spacing, bool anchored,
                                                  const SwathTask& task, const JobContext& job);

/// Adds what is worked along a line, in strips without folds.
void addStrips(const Turn& line, Length width, MultiPolygon& strips);

/// How the swaths of a set cover a mainland, straight or not, with the ends that they have. Cancelled.
Result<StripCoverage> coverageOf(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job);

/// Swaths on these lines, in their order, numbered, with coverage and overlap of flat ends. InputRefused: there are none. Cancelled.
Result<SwathSet> swathsOnLines(const std::vector<SwathLine>& lines, const SwathTask& task, const JobContext& job);

}  // namespace furrow
