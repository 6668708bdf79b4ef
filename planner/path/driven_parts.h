#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/geometry/boundary_distance.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"

#include <vector>

namespace furrow {

/// The parts of an area in which a machine can move, judged by its width only. Immutable; thread-safe.
class DrivenParts {
public:
    /// @param breadth  of the narrowest neck that joins two parts
    static Result<DrivenParts> of(const MultiPolygon& drivable, Length breadth, const JobContext& job);
    /// Necks join two parts if they let the machine through with its implement raised, touching both sides.
    /// @param spare  extra width required in total
    static Result<DrivenParts> of(const AllowedAreas& areas, const Machine& machine, Length spare,
                                  const JobContext& job);

    /// The part in which a place lies, or to which it is nearest. O(edges).
    std::size_t partAt(Point place) const;
    bool separate(Point from, Point to) const;

private:
    explicit DrivenParts(const MultiPolygon& rooms);

    std::vector<BoundaryDistance> edges_;
};

}  // namespace furrow
