#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

namespace furrow {

struct StripCoverage {
    double share = 0.0;  ///< of the mainland that is covered
    Area overlap;        ///< of the mainland that is covered more than once, as often as that
};

/// How strips of any shape cover a mainland. Measured on 2048 lines across `along`, each exactly: good to about a
/// thousandth where strips run along it, as unions of polygons are, which take a hundred times as long where strips
/// share their edges. Cost: O(lines + edges). Cancelled.
Result<StripCoverage> coverageOf(const MultiPolygon& strips, const MultiPolygon& mainland, Angle along,
                                 const JobContext& job);

}  // namespace furrow
