#pragma once

#include "planner/audit/clearance.h"
#include "planner/audit/kinematics.h"
#include "planner/audit/swept_area.h"
#include "planner/audit/tank.h"
#include "planner/audit/traffic.h"

namespace furrow {

/// All available measurements.
struct Measurements {
    const std::vector<SegmentMotion>& motions;
    const MachineShape& shape;
    const SweptArea& area;
    const ClearanceReport* clearance = nullptr;  ///< null without a machine
    const Kinematics& kinematics;
    const Traffic& traffic;
    const TankReport& tank;
};

/// Puts the measurements into words: blocking ones first, each group in driving order.
std::vector<AuditFinding> findingsOf(const AuditInput& input, const Measurements& measured);

}  // namespace furrow
