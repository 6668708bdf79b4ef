#pragma once

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/polygon.h"
#include "planner/machine/machine.h"
#include "planner/turns/turn.h"

#include <span>

namespace furrow {

/// Where and how a line follows.
struct FollowingRules {
    Length beside;  ///< what the footprint keeps from the edge
    /// Around these the line stays as it is: what is outside there is seen to otherwise.
    std::span<const Point> leftOut;
    double aroundM = 0.0;

    bool leavesOut(Point place) const;
};

/// A closed line with the field on its left, moved as near to the edge on its right as tail and nose let it: of all
/// curves beside it the one that lies farthest out everywhere. A corner of the footprint at x ahead of the axle is
/// d + x d' farther in where the line has moved in by d, so that each asks for a least d one step on (nose) or back
/// (tail) that grows with d itself; what satisfies all of these has a least element, found by going round until nothing
/// changes. The same holds for the smallest radius in bends away from the edge; in bends towards it both sides move in a
/// little. To first order: what is still outside by little is left to the caller.
///
/// @param edges  reaches farther than the footprint swings out
/// @return points no farther apart than 0.25 m. Cost: corners of the footprint times points, a few times.
Ring followingTheEdge(const Turn& line, const BoundaryDistance& edges, const Machine& machine, const FollowingRules& rules);

}  // namespace furrow
