#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/geometry/curve.h"
#include "planner/jobs/job.h"
#include "planner/turns/rig.h"
#include "planner/turns/travel_cost.h"

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

/// Ways of a machine that turns on the spot: straight from corner to corner, with a turn at each. The corners
/// are those of the area in which it may turn by any angle; two of them are joined where the machine gets
/// straight from one to the other (visibility graph: Lozano-Pérez & Wesley 1979, doi 10.1145/359156.359164).
/// Thread-safe. A way is the same whether others were searched before or not.
class StraightWays {
public:
    /// @param rig  of this area; outlives this
    /// Without corners if the job is stopped. No ways for a machine that does not turn on the spot.
    StraightWays(const AllowedAreas& areas, const Rig& rig, const JobContext& job);

    /// The quickest of these ways, by A*. It begins with the heading of its first straight; what it turns at
    /// both ends has room. A turn of type kCombinedTurn.
    ///
    /// @param travel  empty: every place costs the same
    /// @return empty if there is none, or if the job was stopped
    /// Cost: a microsecond for each two corners, and some ten for each straight that is tested.
    std::optional<Curve> between(const Pose& leaving, const Pose& arriving, const TravelCost& travel,
                                 const JobContext& job) const;

    const std::vector<Point>& corners() const { return corners_; }

private:
    /// Whether a straight from one corner to another fits: tested once.
    enum class Fit : signed char { Unknown, No, Yes };

    friend class StraightSearch;
    bool leads(Point from, Point to) const;
    bool leadsBetweenCorners(std::size_t from, std::size_t to) const;

    const Rig& rig_;
    std::vector<Point> corners_;
    mutable std::vector<std::atomic<Fit>> fits_;  ///< [from * corners + to]
};

}  // namespace furrow
