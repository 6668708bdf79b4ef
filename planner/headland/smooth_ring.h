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

/// How a ring is cut into stretches.
struct StretchRules {
    Length radius;
    Length tolerance;  ///< that the line may move by where corners are merged
    Length gentle;     ///< bends begin so far before their corner where there is room
    Length width;      ///< of a pass
    Area mostUncut;    ///< between two such passes that are rounded alike
};

/// Lines that follow on each other round a ring.
struct SmoothStretches {
    std::vector<Turn> lines;
    bool closed = false;  ///< one line, which ends where it begins
};

/// A ring in stretches that each can be driven: cut at corners where rounding would leave more than allowed, and
/// where corners are too close to be rounded. Each begins at the corner where the one before ends. None of a ring
/// of less than 3 points. Cost: O(n).
SmoothStretches smoothStretches(const Ring& ring, const StretchRules& rules);

/// The same line driven the other way round.
Turn reversedLine(const Turn& line);

}  // namespace furrow
