#pragma once

#include "planner/audit/motion.h"

namespace furrow {

/// What the footprint of one segment comes to, against the edge of the drivable area.
struct SegmentClearance {
    double clearanceM = 0.0;  ///< negative: that far outside
    Point place;              ///< where it is nearest to the edge, or farthest outside
    bool beyondLand = false;  ///< outside the outer boundary, not in something inside the field
    MultiPolygon suspects;    ///< parts of the swept footprint that may lie outside; they overlap
};

struct ClearanceReport {
    std::vector<SegmentClearance> segments;  ///< one for each segment
    Length smallest;
    Area outside;
};

/// Moves tractor and implement, each a rectangle, along every segment: raised width where the implement is
/// up, operating width where it is down. Between two states a part sweeps the hull of both of its
/// rectangles. `input.machine` must be there. A segment's clearance is what it comes to, or
/// 2 m where it stays farther away than that and another one does not.
Result<ClearanceReport> measureClearance(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                                         const JobContext& job);

}  // namespace furrow
