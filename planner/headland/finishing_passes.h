#pragma once

#include "planner/headland/full_lock_passes.h"
#include "planner/headland/headland.h"
#include "planner/turns/rig.h"

#include <span>

namespace furrow {

extern const Parameter kHeadlandFinish;

/// What other passes leave, and how much of it may stay.
struct FinishingTask {
    const MultiPolygon& workable;  ///< the field less its obstacles and the margin
    const MultiPolygon& left;      ///< not worked although it is within reach, largest first
    Area mayStay;                  ///< in all
    Area mayStayInOnePiece;
    const Rig& lowered;            ///< implement down, in the drivable area
    FullLockPasses* bends = nullptr;  ///< for what cannot reverse
    std::span<const Polygon> leftOnPurpose = {};  ///< no pass works any of it
    std::span<const PassStretch> refused = {};  ///< have no way in or out: not proposed, nor what is nearly one of them
};

/// Short straight passes over what is left at corners and between other passes, along an edge or along the piece
/// itself, either way: the fewest that a greedy choice needs until little enough is left. Before them, where `bends`
/// are given, passes on full lock over what lies at the edges. None where no pass would gain much. Each has one
/// stretch. Cost: some looks at the rig and some GEOS overlays for each. Cancelled.
Result<std::vector<HeadlandPass>> finishingPasses(const FinishingTask& task, const JobContext& job);

}  // namespace furrow
