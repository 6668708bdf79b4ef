#pragma once

#include "planner/geometry/polygon.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

/// A line that does not cut the mainland as it was meant to.
struct SplitFault {
    std::size_t line = 0;  ///< its number, from 0
    Point place;           ///< the end that falls short, or any point of a line outside
    /// From there straight on to the edge, or to another of the lines; none where the line is outside.
    std::optional<Length> missing;
};

/// Lines that are to cut a mainland, as far as they do.
struct SplitLines {
    std::vector<Polyline> lines;
    std::vector<SplitFault> faults;
};

/// Draws lines that end inside the mainland straight on, to its edge or to another of the lines, where that is no
/// farther than `most`; where it is, the line stays as it is and is told. Cost: O(edges) for each end.
SplitLines drawnThrough(std::vector<Polyline> lines, const MultiPolygon& mainland, Length most);

}  // namespace furrow
