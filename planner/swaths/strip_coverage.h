#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

namespace furrow {

struct StripCoverage {
    double share = 0.0;  ///< covered share of the mainland
    Area overlap;        ///< area of the mainland covered more than once, counted for each extra time
};

/// The coverage of a mainland by strips of any shape. 2048 lines across `along` are measured, each exactly.
/// If strips run along it, the error is about a thousandth. Polygon unions have the same error, but take a
/// hundred times as long for strips that share edges. Cost: O(lines + edges). Cancelled.
Result<StripCoverage> coverageOf(const MultiPolygon& strips, const MultiPolygon& mainland, Angle along,
                                 const JobContext& job);

}  // namespace furrow
