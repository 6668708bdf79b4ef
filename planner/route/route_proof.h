#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/route/route.h"

#include <optional>

namespace furrow {

/// How far a route is from the best, in the unit of route.objective: seconds, metres or litres.
struct RouteProof {
    double working = 0.0;     ///< of the swaths, in any order
    double nonWorking = 0.0;  ///< of the turns and ways between them
    /// No order and no directions of these swaths have a lower cost between them.
    double lowerBound = 0.0;

    /// nonWorking / lowerBound - 1, at least 0.
    double gap() const;
    /// The same of the whole cost.
    double gapTotal() const;
    /// Nothing to gain but rounding.
    bool isBest() const;

    friend bool operator==(const RouteProof&, const RouteProof&) = default;
};

/// The cost of a route and a lower bound for all routes over these swaths, by these turns. The larger one of
/// Held and Karp's bound and an assignment's; for few swaths the optimum, by dynamic programming or by branch
/// and bound. Links count with the way that fits where a single curve fits, and as in free space elsewhere.
/// Empty if the route has a link for which no way fits. Cancelled. Cost: milliseconds to a second.
Result<std::optional<RouteProof>> proofOf(const Route& route, const RouteTask& task, const JobContext& job);

}  // namespace furrow
