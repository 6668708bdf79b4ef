#pragma once

#include "planner/audit/audited_land.h"
#include "planner/plan/plan_request.h"
#include "planner/plan/stage_memo.h"
#include "planner/plan/stages.h"

#include <memory>

namespace furrow {

/// What audited land is made from, beside field and machine.
struct AuditedLandInputs {
    std::shared_ptr<const Ground> ground;

    friend bool operator==(const AuditedLandInputs&, const AuditedLandInputs&) = default;
};

/// Plans of one field and machine are measured against the same land. Thread-safe.
using AuditedLands = StageMemo<AuditedLandInputs, AuditedLand, 4>;

/// @param input  of a plan over this ground
/// Cancelled.
Result<std::shared_ptr<const AuditedLand>> auditedLand(AuditedLands& known, const PlanRequest& request,
                                                       const std::shared_ptr<const Ground>& ground,
                                                       const AuditInput& input, const JobContext& job);

}  // namespace furrow
