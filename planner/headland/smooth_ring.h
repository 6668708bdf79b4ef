#pragma once

#include "planner/geometry/curve.h"
#include "planner/geometry/polygon.h"

#include <optional>
#include <vector>

namespace furrow {

/// A ring as lines and arcs that a vehicle can drive. Every corner is rounded with the given radius or more;
/// arcs drawn as chords become arcs again. Corners too close to each other are merged or left out; for each,
/// the line moves by no more than `tolerance`. Starts on the ring's first edge. Empty if that tolerance is
/// not enough. Cost: O(n) for n points.
/// @param gentle  distance before a corner at which its bend begins if there is room. A larger radius makes
/// the tail swing out less.
std::optional<Curve> smoothRing(const Ring& ring, Length radius, Length tolerance, Length gentle = {});

/// Rules for cutting a ring into stretches.
struct StretchRules {
    Length radius;
    Length tolerance;  ///< largest move of the line where corners are merged
    Length gentle;     ///< distance before a corner at which its bend begins if there is room
    Length width;      ///< of a pass
    Area mostUncut;    ///< between two such passes with the same rounding
};

/// Lines round a ring, one after the other.
struct SmoothStretches {
    std::vector<Curve> lines;
    bool closed = false;  ///< one line, which ends at its own beginning
};

/// A ring in stretches, each drivable. It is cut at corners where rounding would leave more than allowed, and
/// at corners too close to be rounded. Each stretch begins at the corner at which the one before ends. Empty
/// for a ring of less than 3 points. Cost: O(n).
SmoothStretches smoothStretches(const Ring& ring, const StretchRules& rules);

/// The same line driven the other way round.
Curve reversedLine(const Curve& line);

}  // namespace furrow
