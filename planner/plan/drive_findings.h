#pragma once

#include "planner/audit/audit.h"
#include "planner/field/allowed_areas.h"
#include "planner/path/drivable_check.h"
#include "planner/path/finding.h"
#include "planner/path/path.h"
#include "planner/plan/plan_request.h"

#include <vector>

namespace furrow {

/// Marks the segments on which the machine leaves the area where it may be. Returns one finding for each way,
/// at its worst place. Cancelled.
Result<std::vector<Finding>> checkWays(Path& path, WayChecks& checks, const AllowedAreas& drivable,
                                       const Machine& machine, const JobContext& job);

/// A note for each stretch that is driven with the implement folded between two pieces of work.
std::vector<Finding> foldedWays(const Path& path);

/// A finding if the path turns on the spot and the machine cannot.
std::optional<Finding> impossibleTurns(const PlanRequest& request, const Path& path);

/// The findings of the audit without those that the planner has told already. The planner's own say what was
/// tried.
std::vector<Finding> newFindings(const AuditReport& audit, const std::vector<Finding>& told,
                                 const Path& path);

}  // namespace furrow
