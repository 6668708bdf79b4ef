#pragma once

#include "planner/audit/motion.h"

#include <array>
#include <limits>
#include <vector>

namespace furrow {

/// The result for the footprint of one segment against the edge of the drivable area.
struct SegmentClearance {
    /// Negative: the distance outside, exact except for one step of a turn. Otherwise no less than the
    /// smallest clearance of the path.
    double clearanceM = std::numeric_limits<double>::infinity();
    Point place;              ///< where it is farthest outside
    bool beyondLand = false;  ///< outside the outer boundary, not in an obstacle inside the field
    /// Parts of the swept footprint that may lie outside: of the tractor and wheels, and of the implement.
    /// They overlap.
    std::array<std::vector<Ring>, 2> suspects;

    bool isSuspect() const { return !suspects[0].empty() || !suspects[1].empty(); }
};

struct ClearanceLand;

struct ClearanceReport {
    std::vector<SegmentClearance> segments;  ///< one for each segment
    Length smallest;
    Area outside;
    Area overhangArea;  ///< swept by the implement outside of the drivable area
    Length overhang;    ///< how far at most
    Point overhangPlace;
};

/// Moves tractor and implement, each a rectangle, along every segment: raised width if the implement is up,
/// operating width if it is down. If the implement may stand over more than the drivable area, the wheels of
/// a trailed one are a third rectangle, which may not. Between two states a part sweeps the hull of both its
/// rectangles. `input.machine` must exist. The smallest clearance of the path, and everything outside, do not
/// depend on the thread count. The clearance of other segments does.
Result<ClearanceReport> measureClearance(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                                         const JobContext& job);
/// The same with the land of this input made before.
Result<ClearanceReport> measureClearance(const AuditInput& input, const ClearanceLand& against,
                                         const std::vector<SegmentMotion>& motions, const JobContext& job);

}  // namespace furrow
