#pragma once

#include "planner/core/message.h"
#include "planner/path/path.h"

#include <span>
#include <vector>

namespace furrow {

/// A turn as a driver would call it, by its driven line.
enum class TurnShape {
    OnTheSpot,  ///< also with a straight way between turns on the spot
    Straight,   ///< hardly turns: from one swath on into the next
    Corner,     ///< one bend of up to 135 degrees
    U,          ///< one bend of about 180 degrees
    Bulb,       ///< swings out to the other side first, or comes back from it (omega)
    Loop,       ///< one bend of more than 235 degrees
    Fishtail,   ///< one stretch backwards between two forwards
    Reversing,  ///< backwards in any other way
};

/// "U turn", "bulb turn" ... in the words of drivers.
Message nameOf(TurnShape shape);

/// Of the segments of one way, in driving order; at least one. Cost: O(samples).
TurnShape turnShape(std::span<const PathSegment> way);

/// One way from swath to swath that is a turn.
struct DrivenTurn {
    std::size_t firstSegment = 0;
    std::size_t segmentCount = 0;
    TurnShape shape = TurnShape::U;
    Duration duration;  ///< with what it turns on the spot and steers standing at its ends
    Length length;
};

/// All turns of a path in driving order: segments of kind Turn that follow on each other are one. Cost:
/// O(samples).
std::vector<DrivenTurn> drivenTurns(const Path& path);

}  // namespace furrow
