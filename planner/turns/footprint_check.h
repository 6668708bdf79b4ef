#pragma once

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/curve.h"

#include <limits>

namespace furrow {

/// Whether a footprint stays inside the edges along a turn, tested at places no farther apart than `step`.
/// Places out of the edges' reach count as inside, so start from a pose that is inside. Cost: corners times
/// places.
bool staysInside(const Curve& turn, const Ring& footprint, const BoundaryDistance& edges, Length step);
bool isInside(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges);

/// The distance of a footprint from the edges that it must not cross. Negative if it crosses them.
struct FootprintRoom {
    double edgesM = 0.0;    ///< from its corners to the edges, at most the edges' reach
    double cornersM = 0.0;  ///< from its sides to inward corners of the field, at most the reach

    double least() const { return edgesM < cornersM ? edgesM : cornersM; }
};
/// @param radiusM  of the footprint
/// @param noLessM  where the least is below this, some value below it is returned: quicker
FootprintRoom roomAround(const Pose& pose, const Ring& footprint, double radiusM,
                         const BoundaryDistance& edges,
                         double noLessM = -std::numeric_limits<double>::infinity());
/// From the reference point to the farthest corner.
double radiusOf(const Ring& footprint);

/// The distance by which the footprint at a pose crosses the edges: with one of its corners, or with a side
/// that a corner of the field pokes into. 0 inside.
double outsideM(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges);

}  // namespace furrow
