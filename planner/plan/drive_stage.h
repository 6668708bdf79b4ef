#pragma once

#include "planner/plan/path_over_legs.h"

#include <optional>

namespace furrow {

/// Lays out the legs of headland, swaths and route with the ways in and out at the gates, and joins them by
/// ways; checks and audits the path, and where more is left than may be adds short passes and does so again.
///
/// @param toBeat  InputRefused for a plan that is no better, as soon as that is known
/// Errors: Usage for a start or end that is none. InputRefused. Cancelled.
Result<Driven> driveStage(const DriveTask& task, std::optional<PlanToBeat> toBeat, const JobContext& job);

}  // namespace furrow
