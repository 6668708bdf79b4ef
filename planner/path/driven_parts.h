#pragma once

#include "planner/geometry/boundary_distance.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"

#include <vector>

namespace furrow {

/// The parts of an area that a tractor can drive about in, as far as its wheels decide. Immutable; any thread may ask.
class DrivenParts {
public:
    /// @param spare  beside the tractor, in a neck that joins two of them
    static Result<DrivenParts> of(const MultiPolygon& drivable, const Machine& machine, Length spare, const JobContext& job);

    /// Whether two places lie in different ones, or nearest to them. O(edges).
    bool separate(Point from, Point to) const;

private:
    std::size_t partAt(Point place) const;

    std::vector<BoundaryDistance> edges_;
};

}  // namespace furrow
