#pragma once

#include "planner/audit/motion.h"

namespace furrow {

/// What the working line sweeps, and what that does to the field.
struct SweptArea {
    MultiPolygon missed;  ///< of the workable area, largest first
    Area covered;
    Area missedArea;
    Area overlap;
    Area overlapHeadland;
    Area error;
    std::optional<double> coveredOfReachable;  ///< empty without a machine
    MultiPolygon missedWithinReach;            ///< all that is missed where there is no machine
    std::vector<MultiPolygon> passes;          ///< swept by each segment; empty where the implement is up
};

Result<SweptArea> measureSweptArea(const AuditInput& input, const MachineShape& shape,
                                   const std::vector<SegmentMotion>& motions, const JobContext& job);

}  // namespace furrow
