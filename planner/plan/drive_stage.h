#pragma once

#include "planner/plan/plan.h"

#include <optional>

namespace furrow {

/// Lays out what the machine drives from a plan's headland, swaths and route, with the ways in and out at its gates,
/// and joins it by ways; checks and audits the path, and where more is left than may be adds short passes and does so
/// again. Fills the plan's path, audit, findings and the timings of both.
///
/// @param drivable  where the machine may be, gates closed
/// @param atMost    a path that takes longer is refused before it is audited
/// Errors: Usage for a start or end that is none. InputRefused. Cancelled.
Result<void> driveStage(Plan& plan, const MultiPolygon& drivable, std::optional<Duration> atMost, const JobContext& job);

}  // namespace furrow
