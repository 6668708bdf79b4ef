#pragma once

#include "planner/plan/path_over_legs.h"

#include <optional>

namespace furrow {

/// The driven plan: legs over headland and swaths in the order of the route, ways between them and at the
/// gates, checks and audit, short passes where too much is left, and trips to refill points.
///
/// @param toBeat  the best plan so far. InputRefused: this one cannot be better.
/// Errors: Usage, if start or end is no place. InputRefused. Cancelled.
Result<Driven> driveStage(const DriveTask& task, std::optional<PlanToBeat> toBeat, const JobContext& job);

}  // namespace furrow
