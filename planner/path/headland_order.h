#pragma once

#include "planner/headland/full_lock_passes.h"
#include "planner/headland/headland.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"

#include <optional>

namespace furrow {

/// In which order, from where and to where the passes of a headland are driven.
struct HeadlandDrive {
    bool insideOut = false;
    /// The pose that follows (the first swath's start) or precedes (the last swath's end); the passes are
    /// rotated so that the ways between them and to it are short. Nothing where there are no swaths.
    std::optional<Pose> before;  ///< what is driven right before the headland
    std::optional<Pose> after;   ///< what is driven right after it
    const MultiPolygon& drivable;  ///< the ways between passes stay in here where that is possible
};

/// The legs of all passes, ring by ring around each boundary or obstacle, nearest first. Each closed pass starts
/// where the way from the one before it, or to the one after it, is quickest. Cost: a few hundred turns for each
/// pass.
std::vector<Leg> headlandLegs(const std::vector<HeadlandPass>& passes, const HeadlandDrive& drive,
                              const Machine& machine, TurnPlanner* turn);

/// The leg before which a pass is best driven: where the detour is short, and the ways there and on are quickly found.
struct PassPlace {
    PassAccess access = PassAccess::NoWayIn;
    std::size_t before = 0;  ///< where there are ways
};
PassPlace placeFor(const Turn& line, const std::vector<Leg>& legs, RememberedWays& ways, const JobContext& job);

struct FinishedLegs {
    std::vector<Leg> legs;
    std::vector<HeadlandPass> put;
    std::vector<HeadlandPass> refused;  ///< no way in or out was found
};

/// The same legs with short passes driven in between, each where the way there and on is short and quickly found.
FinishedLegs withFinishingPasses(std::vector<Leg> legs, const std::vector<HeadlandPass>& passes, RememberedWays& ways,
                                 const JobContext& job);

}  // namespace furrow
