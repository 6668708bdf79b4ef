#pragma once

#include "planner/geometry/boundary_distance.h"
#include "planner/turns/turn.h"

namespace furrow {

/// Whether a footprint keeps inside the edges while it is driven along a turn, asked at places no farther apart
/// than `step`. What is out of the edges' reach counts as inside: start from a pose that is. Cost: corners times
/// places.
bool staysInside(const Turn& turn, const Ring& footprint, const BoundaryDistance& edges, Length step);
bool isInside(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges);

/// How far a footprint is from what it must not cross; negative where it does.
struct FootprintRoom {
    double edgesM = 0.0;    ///< from its corners to the edges, no more than the edges' reach
    double cornersM = 0.0;  ///< from its sides to corners of the field that poke inwards, as much

    double least() const { return edgesM < cornersM ? edgesM : cornersM; }
};
/// @param radiusM  of the footprint
FootprintRoom roomAround(const Pose& pose, const Ring& footprint, double radiusM, const BoundaryDistance& edges);
/// From the reference point to the farthest corner.
double radiusOf(const Ring& footprint);

/// How far the footprint at a pose gets across the edges: with one of its corners, or with a side that a corner of
/// the field pokes into. 0 inside.
double outsideM(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges);

}  // namespace furrow
