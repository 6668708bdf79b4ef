#pragma once

#include "planner/audit/kinematics.h"

namespace furrow {

/// The level of tank or bunker, re-derived from the machine's rate and the ways that are worked.
struct TankReport {
    Trouble beyond;        ///< work with the tank empty or the bunker full, by what share of the tank
    double beyondM = 0.0;  ///< of way that is worked so
    Trouble mismatch;      ///< the stated level differs, by what share of the tank
    Trouble away;          ///< it changes away from all refill points, m beyond their reach
    Trouble standing;      ///< it changes, and the machine does not stand as long as that takes, s
};

/// Nothing is found without a tank in the input. O(samples * refill points).
TankReport measureTank(const AuditInput& input);

}  // namespace furrow
