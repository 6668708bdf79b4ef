#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/swaths/swath.h"

#include <span>
#include <vector>

namespace furrow {

/// What swaths are led round, and within what.
struct WayRoundTask {
    const MultiPolygon& drivable;     ///< where tractor and implement may be
    std::span<const Ring> obstacles;  ///< holes of that, but for the margin
    const Machine& machine;
    Length margin;  ///< that is kept from them
};

/// Leads the swaths on which the machine would touch one of these obstacles round it: to the side that leaves less
/// unworked, by arcs no sharper than the machine can drive, so far that tractor and implement stay clear whichever way
/// the swath is driven, and back. Obstacles that are closer to each other than that takes are passed in one go; near its
/// end a swath may begin or end beside its track.
///
/// @return by index, rising, the obstacles that some swath does not get round, or only by leaving more than may stay in
/// one piece. Swaths that touch these keep their lines. Cancelled. Cost: some milliseconds for each obstacle and swath
/// that meet.
Result<std::vector<std::size_t>> leadRound(SwathSet& set, const WayRoundTask& task, const JobContext& job);

}  // namespace furrow
