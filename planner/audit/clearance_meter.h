#pragma once

#include "planner/audit/boundary_index.h"
#include "planner/audit/clearance.h"

#include <vector>

namespace furrow {

/// The clearance of convex pieces from the edges of an area. Immutable; thread-safe.
class ClearanceMeter {
public:
    /// @param land  the area without holes
    ClearanceMeter(const MultiPolygon& area, const MultiPolygon& land) : edges_{area}, land_{land} {}

    /// Whether everything within a distance of a place is inside.
    bool isFree(Point middle, double radius) const { return edges_.containsDisc(middle, radius); }

    /// Whether everything within a distance of a place is outside.
    bool isBeyond(Point middle, double radius) const {
        return !edges_.contains(middle) && edges_.distance(middle) > radius;
    }

    /// Lowers `found` to the clearance of this convex piece if that is less and under `limit`. Returns
    /// whether some of it may lie outside.
    bool measure(const Ring& hull, double limit, SegmentClearance& found) const;

private:
    void measureOutside(const Ring& hull, const std::vector<Edge>& intruding, SegmentClearance& found) const;

    BoundaryIndex edges_;
    BoundaryIndex land_;
};

}  // namespace furrow
