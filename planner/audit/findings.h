#pragma once

#include "planner/audit/clearance.h"
#include "planner/audit/kinematics.h"
#include "planner/audit/swept_area.h"
#include "planner/audit/traffic.h"

namespace furrow {

/// Everything that was measured, as far as it could be.
struct Measurements {
    const std::vector<SegmentMotion>& motions;
    const MachineShape& shape;
    const SweptArea& area;
    const ClearanceReport* clearance = nullptr;  ///< none without a machine
    const Kinematics& kinematics;
    const Traffic& traffic;
};

/// Puts what was measured into words: blocking ones first, each group in driving order.
std::vector<AuditFinding> findingsOf(const AuditInput& input, const Measurements& measured);

}  // namespace furrow
