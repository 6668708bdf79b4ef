#pragma once

#include "planner/audit/motion.h"

#include <array>
#include <limits>
#include <vector>

namespace furrow {

/// What the footprint of one segment comes to, against the edge of the drivable area.
struct SegmentClearance {
    /// Negative: that far outside, to what one step of a turn cuts off. Otherwise no less than the smallest of
    /// the path.
    double clearanceM = std::numeric_limits<double>::infinity();
    Point place;              ///< where it is farthest outside
    bool beyondLand = false;  ///< outside the outer boundary, not in something inside the field
    /// Parts of the swept footprint that may lie outside, of the tractor and of the implement; they overlap.
    std::array<std::vector<Ring>, 2> suspects;

    bool isSuspect() const { return !suspects[0].empty() || !suspects[1].empty(); }
};

struct ClearanceReport {
    std::vector<SegmentClearance> segments;  ///< one for each segment
    Length smallest;
    Area outside;
};

/// Moves tractor and implement, each a rectangle, along every segment: raised width where the implement is
/// up, operating width where it is down. Between two states a part sweeps the hull of both of its
/// rectangles. `input.machine` must be there. The smallest clearance of the path, and all that is outside, do
/// not depend on the thread count; the clearance of a segment that is neither does.
Result<ClearanceReport> measureClearance(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                                         const JobContext& job);

}  // namespace furrow
