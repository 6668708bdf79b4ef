#pragma once

#include "planner/field/field.h"
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

/// Where tractor and implement may be: the field less `margin` and less the obstacles that may not be driven
/// on, with the gates open. Cancelled.
Result<MultiPolygon> drivableArea(const Field& field, Length margin, const JobContext& job);

/// Connections whose footprint leaves the drivable area: the outline of tractor and raised implement at
/// every sample and the track of each of its corners, less `margin` from the boundary. Gates are open.
/// Cost: about 20 microseconds for each sample. Cancelled.
Result<std::vector<BlockedConnection>> blockedConnections(const Path& path, const Field& field,
                                                          const Machine& machine, Length margin,
                                                          const JobContext& job);

}  // namespace furrow
