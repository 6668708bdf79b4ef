#pragma once

#include "planner/swaths/guide_line.h"
#include "planner/swaths/mainland_edges.h"
#include "planner/swaths/scan_line.h"
#include "planner/swaths/strip_coverage.h"

#include <vector>

namespace furrow {

/// The smallest radius for the middle of a swath: the machine's, plus the lateral offset of its implement.
Length swathRadius(const Machine& machine);

/// A line to work along, inside the mainland.
struct SwathLine {
    int track = 0;
    Curve line;
    std::optional<int> lane = {};
};

/// The places of the tracks, in metres to the left of a reference, rising. The mainland reaches from `lowM`
/// to `highM`.
/// @param anchored  one track lies at 0 if that is inside, and the others whole steps from it, as with an AB
/// line. Otherwise the first is flush with the lower edge.
std::vector<double> trackPlaces(double lowM, double highM, const SwathSpacing& spacing, bool anchored);

/// The parallels of a guide line over the whole mainland, cut to it, spaced and anchored as above. Parts
/// shorter than one operating width are left out if they are remains of a bend. Cancelled. InputRefused: over
/// a million tracks.
Result<std::vector<SwathLine>> parallelSwathLines(const GuideLine& guide, const SwathSpacing& spacing,
                                                  bool anchored, const SwathTask& task,
                                                  const JobContext& job);

/// Adds the area worked along a line, as strips without folds.
void addStrips(const Curve& line, Length width, MultiPolygon& strips);

/// The coverage of a mainland by the swaths of a set, straight or not, with their present ends. Cancelled.
Result<StripCoverage> coverageOf(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job);

/// Swaths on these lines, in their order, numbered, with coverage and overlap of flat ends. InputRefused: no
/// lines. Cancelled.
Result<SwathSet> swathsOnLines(const std::vector<SwathLine>& lines, const SwathTask& task,
                               const JobContext& job);

}  // namespace furrow
