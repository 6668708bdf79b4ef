#pragma once

#include "planner/geometry/polygon.h"
#include "planner/headland/full_lock_bend.h"
#include "planner/jobs/job.h"
#include "planner/turns/rig.h"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// A pass with bends.
struct BentPass {
    Curve line;           ///< of the vehicle's reference point
    MultiPolygon worked;  ///< what the implement sweeps
};

/// Whether a way leads to the pass and away from it.
enum class PassAccess { There, NoWayIn, NoWayOut };
using PassAccessFinder = std::function<PassAccess(const Curve& line)>;

/// Poses to which no way leads, and from which none leads away.
struct FailedPoses {
    std::vector<Pose> notReached;
    std::vector<Pose> notLeft;
};

/// Bends round pieces of land that were tried before, in one area with one machine. What is known changes no
/// result. May be used by several threads at once.
class FullLockTrials {
public:
    FullLockTrials();
    ~FullLockTrials();
    FullLockTrials(const FullLockTrials&) = delete;
    FullLockTrials& operator=(const FullLockTrials&) = delete;

private:
    friend class FullLockPasses;
    struct Known;
    std::unique_ptr<Known> known_;
};

/// Passes round one place on full lock, for machines that leave tips and ears only forwards. The outer end of
/// the implement describes the sharpest edge that they can work.
class FullLockPasses {
public:
    /// @param areas    of `lowered`
    /// @param lowered  outlives this
    /// @param trials   of this machine in these areas; its own if null
    /// Cancelled.
    static Result<FullLockPasses> of(const AllowedAreas& areas, const Rig& lowered, PassAccessFinder access,
                                     const JobContext& job, std::shared_ptr<FullLockTrials> trials = nullptr);

    /// The pass that works most of a piece: straight in, on full lock as far round as is useful, straight
    /// out. The implement is in line at both ends. Empty if no pass has room to work any of the piece, or a
    /// way in and out. That piece is then not tried again, nor are poses near those that no way leads to.
    /// Cost: some thousand bends, of which the room is looked at where they may be the best, for a piece that
    /// was not tried before.
    /// @param isRefused  whether nearly the same pass has failed before
    std::optional<BentPass> over(const Polygon& piece, const std::function<bool(const Curve&)>& isRefused,
                                 const JobContext& job);

    /// Works out, on several threads, what `over` needs first of these pieces. Changes no result.
    /// Cancelled.
    Result<void> lookAhead(std::span<const Polygon> pieces,
                           const std::function<bool(const Curve&)>& isRefused, const JobContext& job) const;

    /// Other legs may have ways to the poses that none led to.
    void forgetFailedPoses() { failed_ = {}; }

private:
    friend class FullLockTrials;
    class Trial;
    struct Bend;
    struct Piece;
    FullLockPasses(const Rig& lowered, PassAccessFinder access, std::shared_ptr<FullLockTrials> trials);

    Result<std::shared_ptr<Piece>> tried(const Polygon& piece, const JobContext& job) const;
    /// The straight before a bend, for so many lengths of the trailed part.
    double leadM(double lengths) const;
    /// Poses closer than this are one.
    double closeM() const;

    std::optional<BentPass> worked(Curve line, const JobContext& job) const;

    const Rig* lowered_;
    PassAccessFinder access_;
    std::optional<Trailer> trailer_;
    Length look_;                      ///< between two states of a bend
    std::vector<FullLockBend> bends_;  ///< to the left, to the right
    double radiusM_ = 0.0;             ///< of the circle that the tractor drives
    double outerM_ = 0.0;     ///< of the circle that the outer end of the implement finally describes
    double straightM_ = 0.0;  ///< distance until the implement is in line
    MultiPolygon middles_;    ///< of the circles that the outer end of the implement may describe
    std::shared_ptr<FullLockTrials> trials_;
    std::vector<Polygon> hopeless_;
    FailedPoses failed_;
};

}  // namespace furrow
