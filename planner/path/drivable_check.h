#pragma once

#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/path/path.h"

namespace furrow {

/// A connection that the machine cannot drive, found on the path.
struct BlockedConnection {
    std::size_t segment = 0;  ///< index into the path
    bool obstacle = false;    ///< it crosses an obstacle; otherwise it leaves the field
    Point place;              ///< where the footprint is farthest out
    Length outside;           ///< by how much
};

/// Connections and headland passes whose footprint leaves the drivable area: of connections the outline of tractor
/// and raised implement, folded on ways in and out, at every sample and the track of each of its corners; of passes, which are long, the
/// outline with the implement down every half metre.
/// @param drivable  of drivableArea
/// Cost: about 20 microseconds for each sample of a connection. Cancelled.
Result<std::vector<BlockedConnection>> blockedConnections(const Path& path, const MultiPolygon& drivable,
                                                          const Machine& machine, const JobContext& job);

}  // namespace furrow
