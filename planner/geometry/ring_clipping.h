#pragma once

#include "planner/geometry/polygon.h"

#include <vector>

namespace furrow {

/// The part of a ring inside a convex ring (Sutherland & Hodgman 1974, doi 10.1145/360767.360802). Separate
/// parts stay joined by edges without area between them. Keeps its memory from one ring to the next.
class RingClipping {
public:
    /// @param convex  counter-clockwise
    /// @return empty where nothing is inside; valid until the next call. Cost: O(points times edges); an edge
    ///         that cuts nothing off costs a look at every point.
    const Ring& clipped(const Ring& ring, const Ring& convex);

private:
    const Ring* leftOf(const Ring& ring, Point on, Point along, Ring& kept);

    std::vector<double> left_;  ///< of the points, how far they lie on the left of the line
    Ring first_;
    Ring second_;
};

}  // namespace furrow
