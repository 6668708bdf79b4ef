#pragma once

#include "planner/geometry/curve.h"
#include "planner/geometry/point_grid.h"
#include "planner/geometry/polygon.h"
#include "planner/machine/machine.h"
#include "planner/turns/allowed_edges.h"

namespace furrow {

/// Rules for a line that follows an edge.
struct FollowingRules {
    Length beside;  ///< distance that the footprint keeps from the edge
    /// The line stays unchanged near these points. Another manoeuvre takes it inside there.
    PointGrid leftOut;
    double aroundM = 0.0;

    bool leavesOut(Point place) const;
};

/// Moves a closed line, the field on its left, as near to the edge on its right as tail and nose allow. The
/// result is the curve that lies farthest out everywhere. d is the distance by which a station has moved in.
/// A corner of the footprint at x ahead of the axle is then d + x d' farther in. Each corner therefore
/// demands a least d at the next station (nose) or the previous one (tail), and this demand grows with d. All
/// demands together have a least solution; repeated rounds find it. The smallest radius in bends away from
/// the edge is such a demand, too. In bends towards the edge both sides move in a little. The method is of
/// first order: the caller corrects small remaining errors.
///
/// The middle of the implement's side stays inside, since it is to work up to the edge; its corners may
/// overhang.
///
/// @param edges  its range is larger than the swing of the footprint
/// @return points no farther apart than 0.25 m. Cost: a few times corners of the footprint times points.
Ring followingTheEdge(const Curve& line, const AllowedEdges& edges, const Machine& machine,
                      const FollowingRules& rules);

}  // namespace furrow
