#pragma once

#include "planner/geometry/polygon.h"
#include "planner/turns/turn.h"

#include <optional>
#include <vector>

namespace furrow {

/// A ring as lines and arcs that a vehicle can drive: every corner is rounded with the given radius or more,
/// arcs drawn as chords become arcs again. Where corners are too close to each other some are merged or left out;
/// the line moves by no more than `tolerance` for each. Starts on the ring's first edge. Nothing where that is not
/// enough. Cost: O(n) for n points.
/// @param gentle  bends begin so far before their corner where there is room: the larger the radius, the less the
///                tail swings out
std::optional<Turn> smoothRing(const Ring& ring, Length radius, Length tolerance, Length gentle = {});

/// The same in stretches that each can be driven: cut at corners where rounding would leave more than `mostUncut`
/// between two passes of this width, and where corners are too close to be rounded. One closed stretch where
/// there is none; otherwise each begins at the corner where the one before ends. No stretch of a ring of less than
/// 3 points. Cost: O(n).
struct SmoothStretches {
    std::vector<Turn> lines;
    bool closed = false;
};
SmoothStretches smoothStretches(const Ring& ring, Length radius, Length tolerance, Length width, Area mostUncut);

/// The same line driven the other way round.
Turn reversedLine(const Turn& line);

}  // namespace furrow
