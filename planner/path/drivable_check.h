#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/path/path.h"

namespace furrow {

/// A connection that the machine cannot drive, found on the path.
struct BlockedConnection {
    std::size_t segment = 0;  ///< index into the path
    bool obstacle = false;    ///< it crosses an obstacle; if false, it leaves the field
    Point place;              ///< where the footprint is farthest out
    Length outside;           ///< the distance outside there
};

/// Connections and headland passes whose tractor or implement leaves its area. For connections, the outline
/// of tractor and raised implement (or folded) is tested at every sample, with the track of
/// each of its corners. Passes are long: the outline with the implement down is tested every half metre.
/// @param drivable  from allowedAreas
/// Cost: about 20 microseconds for each sample of a connection. Cancelled.
Result<std::vector<BlockedConnection>> blockedConnections(const Path& path, const AllowedAreas& drivable,
                                                          const Machine& machine, const JobContext& job);

}  // namespace furrow
