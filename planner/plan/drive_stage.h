#pragma once

#include "planner/plan/path_over_legs.h"

#include <optional>

namespace furrow {

/// Lays out the legs of headland, swaths and route with the ways in and out at the gates, and joins them by
/// ways; checks and audits the path, and where more is left than may be adds short passes and does so again.
///
/// @param atMost  a path that takes longer is refused before it is audited
/// Errors: Usage for a start or end that is none. InputRefused. Cancelled.
Result<Driven> driveStage(const DriveTask& task, std::optional<Duration> atMost, const JobContext& job);

}  // namespace furrow
