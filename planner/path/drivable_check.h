#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/path/path.h"

#include <memory>
#include <vector>

namespace furrow {

/// A connection that the machine cannot drive, found on the path.
struct BlockedConnection {
    std::size_t segment = 0;  ///< index into the path
    bool obstacle = false;    ///< it crosses an obstacle; if false, it leaves the field
    Point place;              ///< where the footprint is farthest out
    Length outside;           ///< the distance outside there
};

/// Tests paths of one machine in one area, and remembers the result for every way that the machine drove. A
/// path that differs by a few ways costs only those. A result is the same whether it was tested before or
/// not. May be used by several threads at once.
class WayChecks {
public:
    /// @param drivable  from allowedAreas
    WayChecks(const AllowedAreas& drivable, const Machine& machine);
    ~WayChecks();
    WayChecks(const WayChecks&) = delete;
    WayChecks& operator=(const WayChecks&) = delete;

    /// Connections and headland passes whose tractor or implement leaves its area. For connections, the
    /// outline of tractor and raised implement (or folded) is tested at every sample, with the track of each
    /// of its corners. Passes are long: the outline with the implement down is tested every half metre.
    /// Cost: about 20 microseconds for each sample of a connection that is new. Cancelled.
    Result<std::vector<BlockedConnection>> blocked(const Path& path, const JobContext& job);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// The same for one path.
Result<std::vector<BlockedConnection>> blockedConnections(const Path& path, const AllowedAreas& drivable,
                                                          const Machine& machine, const JobContext& job);

}  // namespace furrow
