#pragma once

#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/turns/rig.h"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

/// A pass with its bends.
struct BentPass {
    Turn line;            ///< of the vehicle's reference point
    MultiPolygon worked;  ///< what the implement sweeps
};

/// Whether a pass can be driven to and on from.
enum class PassAccess { There, NoWayIn, NoWayOut };
using PassAccessFinder = std::function<PassAccess(const Turn& line)>;

/// Passes round one place on full lock, for machines that get out of tips and ears only forwards: the outer end of the
/// implement describes the sharpest edge there is for them.
class FullLockPasses {
public:
    /// @param drivable  where `lowered` may be
    /// @param lowered  outlives this
    /// Cancelled.
    static Result<FullLockPasses> of(const MultiPolygon& drivable, const Rig& lowered, PassAccessFinder access,
                                     const JobContext& job);

    /// The pass that works most of a piece: straight in, as far round as is of use, straight out, the implement in line
    /// at both ends. Nothing where there is no room for one that works any of it, nor a way in and out; that piece is
    /// not looked at again. Cost: some thousand bends driven.
    /// @param isRefused  what is nearly the same was tried
    std::optional<BentPass> over(const Polygon& piece, const std::function<bool(const Turn&)>& isRefused, const JobContext& job);

private:
    class Trial;
    FullLockPasses(const Rig& lowered, PassAccessFinder access);

    std::optional<BentPass> worked(Turn line, const JobContext& job) const;
    /// The line on which the implement works.
    std::pair<Point, Point> workingLine(const RigState& state) const;
    std::optional<Point> nearestMiddle(Point place) const;

    const Rig* lowered_;
    PassAccessFinder access_;
    std::optional<Trailer> trailer_;
    double radiusM_ = 0.0;    ///< of the circle that the tractor drives
    double outerM_ = 0.0;     ///< of the one that the outer end of the implement describes in the end
    double straightM_ = 0.0;  ///< until the implement is in line
    MultiPolygon middles_;    ///< of the circles that the outer end of the implement may describe
    std::vector<Polygon> hopeless_;
};

}  // namespace furrow
