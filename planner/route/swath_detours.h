#pragma once

#include "planner/core/result.h"
#include "planner/field/allowed_areas.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/swaths/swath.h"

#include <span>
#include <vector>

namespace furrow {

/// The obstacles that swaths go round, and the room for it.
struct DetourTask {
    const AllowedAreas& drivable;
    std::span<const Ring> obstacles;  ///< holes of that area, without the margin
    const Machine& machine;
    Length margin;  ///< distance kept from the obstacles
};

/// Leads the swaths on which the machine would touch one of these obstacles round it and back, on the side
/// that leaves less unworked. The arcs are no sharper than the machine can drive. The shift is large enough
/// that tractor and implement stay clear in both directions of driving. Obstacles too close for separate
/// detours share one. Near its end a swath may begin or end beside its track.
///
/// @return indices, rising, of the obstacles that some swath does not get round, or only by leaving more than
/// may stay in one piece. Swaths that touch these keep their lines. Cancelled. Cost: some milliseconds for
/// each obstacle and swath that meet.
Result<std::vector<std::size_t>> addDetours(SwathSet& set, const DetourTask& task, const JobContext& job);

}  // namespace furrow
