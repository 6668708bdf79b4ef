#pragma once

#include "planner/audit/audit.h"
#include "planner/path/finding.h"
#include "planner/path/path.h"
#include "planner/plan/plan_request.h"

#include <vector>

namespace furrow {

/// Marks the segments of a path that leave where the machine may be, and tells them: a way in several gears
/// once, at its worst place. Cancelled.
Result<std::vector<Finding>> checkWays(Path& path, const MultiPolygon& drivable, const Machine& machine,
                                       const JobContext& job);

/// Turns on the spot by a machine that cannot turn on the spot; nothing without.
std::optional<Finding> impossibleTurns(const PlanRequest& request, const Path& path);

/// The findings of an audit that the planner's own do not tell already: those know what was tried.
std::vector<Finding> newFindings(const AuditReport& audit, const std::vector<Finding>& told,
                                 const Path& path);

}  // namespace furrow
