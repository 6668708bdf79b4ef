#pragma once

#include "planner/headland/full_lock_passes.h"
#include "planner/headland/headland.h"
#include "planner/turns/rig.h"

#include <cstddef>
#include <span>

namespace furrow {

extern const Parameter kHeadlandFinish;

/// Of one field: with more of them nobody finds the way. What is left then blocks the plan. Two hundred poles
/// in a field take six hundred.
inline constexpr std::size_t kMostFinishingPasses = 640;

/// The land that other passes leave, and the amount that may stay.
struct FinishingTask {
    const MultiPolygon& workable;  ///< the field less its obstacles and the margin
    const MultiPolygon& left;      ///< not worked although within reach, largest first
    Area mayStay;                  ///< in total
    Area mayStayInOnePiece;
    const Rig& lowered;                           ///< implement down, in the drivable area
    FullLockPasses* bends = nullptr;              ///< for machines that cannot reverse
    std::span<const Polygon> leftOnPurpose = {};  ///< no pass works any of it
    std::span<const PassStretch> refused = {};    ///< no way in or out; left out, with nearly equal ones
    std::size_t most = kMostFinishingPasses;      ///< passes
    /// What is left blocks the plan: passes that gain little are wanted, too, and are searched more finely.
    bool untilTheLeast = false;
};

/// Short straight passes over the land left at corners and between other passes. Each runs along an edge or
/// along the piece itself, in either direction. A greedy choice adds passes until little enough is left. If
/// `bends` is given, passes on full lock over land at the edges come first. No pass is returned that would
/// gain little, and no more than `most`. Each has one stretch. Cost: some checks of the rig
/// and some GEOS overlays for each. Cancelled.
Result<std::vector<HeadlandPass>> finishingPasses(const FinishingTask& task, const JobContext& job);

}  // namespace furrow
