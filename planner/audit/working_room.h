#pragma once

#include "planner/audit/boundary_index.h"
#include "planner/audit/footprint.h"
#include "planner/audit/motion.h"

#include <vector>

namespace furrow {

/// Where a machine that steers a mounted implement has room to work: no part of it is outside the drivable area there,
/// the implement down, nor on the way as long as its run-in that has led there, straight or on full lock.
class WorkingRoom {
public:
    WorkingRoom(const MultiPolygon& drivable, const Machine& machine, const MachineShape& shape);

    /// Whether the working line lies over a place somewhere where there is room. Headings are looked at in steps of
    /// 7.5 degrees, along the edges near the place and across them; where across the heading the machine is, exactly.
    /// O(headings x edges within the machine's reach).
    bool reaches(Point place) const;

private:
    /// What the parts of the machine sweep on one way, convex rings around the middle of the working line at its end,
    /// nose to +x.
    using Sweep = std::vector<Ring>;

    bool reachesAhead(Point place, Point nose, const std::vector<Edge>& edges, const Sweep& sweep) const;

    BoundaryIndex edges_;
    std::vector<Sweep> sweeps_;
    double halfWidthM_ = 0.0;
    double lookM_ = 0.0;  ///< no part is farther from a place that is worked
};

/// The parts of polygons that are within reach in this sense, largest first, told by squares of a quarter of a metre
/// to one and a half, the larger the piece. What is
/// larger than 1,000 m², and what comes after 2 ha of smaller ones, stays as it is. O(area x what one place costs). Cancelled.
Result<MultiPolygon> partsWithRoom(const MultiPolygon& polygons, const WorkingRoom& room, Length operatingWidth,
                                   const JobContext& job);

}  // namespace furrow
