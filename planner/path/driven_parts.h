#pragma once

#include "planner/geometry/boundary_distance.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"

#include <vector>

namespace furrow {

/// The parts of an area that a machine can drive about in, as far as its width decides. Immutable; any thread may ask.
class DrivenParts {
public:
    /// @param breadth  of the narrowest neck that joins two of them
    static Result<DrivenParts> of(const MultiPolygon& drivable, Length breadth, const JobContext& job);
    /// Through necks that let the machine through with its implement raised, touching both sides.
    /// @param spare  that they have to be broader, in all
    static Result<DrivenParts> of(const MultiPolygon& drivable, const Machine& machine, Length spare, const JobContext& job);

    /// The one in which a place lies, or to which it is nearest. O(edges).
    std::size_t partAt(Point place) const;
    bool separate(Point from, Point to) const;

private:
    std::vector<BoundaryDistance> edges_;
};

}  // namespace furrow
