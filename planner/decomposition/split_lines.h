#pragma once

#include "planner/geometry/polygon.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

/// A line that does not cut the mainland as intended.
struct SplitFault {
    std::size_t line = 0;  ///< its number, from 0
    Point place;           ///< the end that falls short, or any point of a line outside
    /// The straight distance from there to the edge, or to another of the lines. Empty if the line is
    /// outside.
    std::optional<Length> missing;
};

/// Lines that cut a mainland, and their faults.
struct SplitLines {
    std::vector<Polyline> lines;
    std::vector<SplitFault> faults;
};

/// Extends lines that end inside the mainland straight to its edge or to another of the lines, if that is no
/// farther than `most`. Otherwise the line stays unchanged and is reported. Cost: O(edges) for each end.
SplitLines drawnThrough(std::vector<Polyline> lines, const MultiPolygon& mainland, Length most);

}  // namespace furrow
