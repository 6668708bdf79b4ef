#pragma once

#include "planner/plan/plan.h"

namespace furrow {

/// Where a field is narrower than its machine, or than the room in which the machine turns round without
/// reversing. Right-angled corners are not narrow.
class NarrowPlaces {
public:
    /// Cancelled. Cost: O(n log n) of the area's points.
    static Result<NarrowPlaces> of(const Plan& plan, const JobContext& job);

    /// Why the machine cannot stay inside at a place of the field, or beside it, and what helps, in one
    /// sentence. Empty where the field is wide enough.
    Message reasonAt(Point place) const;

private:
    NarrowPlaces() = default;

    MultiPolygon area_;         ///< where the machine may stand
    MultiPolygon machineFits_;  ///< centres of discs in it that are as broad as the machine
    MultiPolygon turnFits_;     ///< the same of its turn
    Length machineWidth_;
    Length turnWidth_;
};

}  // namespace furrow
