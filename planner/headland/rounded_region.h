#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

namespace furrow {

// Internal to the headland passes.

/// Tolerance for drawing an arc around an inward corner.
inline constexpr Length kRoundTolerance = metres(0.01);

/// The region that a vehicle can drive along: inward corners cut back to the radius, outward ones rounded,
/// necks cut. Cost: some GEOS overlays. Cancelled.
Result<MultiPolygon> roundedRegion(const Polygon& region, Length radius, const JobContext& job);

}  // namespace furrow
