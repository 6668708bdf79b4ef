#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/headland/full_lock_passes.h"
#include "planner/headland/headland.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"

#include <optional>

namespace furrow {

/// The order, start and end for driving the passes of a headland.
struct HeadlandDrive {
    bool insideOut = false;
    /// The pose that follows (the first swath's start) or precedes (the last swath's end). The passes are
    /// rotated so that the ways between them and to it are short. Empty if there are no swaths.
    std::optional<Pose> before;    ///< end of the leg right before the headland
    std::optional<Pose> after;     ///< start of the leg right after the headland
    const AllowedAreas& drivable;  ///< the ways between passes stay inside if possible
};

/// The legs of all passes, ring by ring around each boundary or obstacle, nearest first. Each closed pass
/// starts where the way from the pass before, or to the pass after, is quickest. Cost: a few hundred turns
/// for each pass.
std::vector<Leg> headlandLegs(const std::vector<HeadlandPass>& passes, const HeadlandDrive& drive,
                              const Machine& machine, TurnPlanner* turn);

/// Whether a pass may be driven between two of the legs near it. Looks for ways that are quickly found.
/// @param ends  of the legs, by endsOf
PassAccess accessTo(const Curve& line, const std::vector<Leg>& legs, const std::vector<Pose>& ends,
                    RememberedWays& ways, const JobContext& job);

/// The poses at which the legs end. Those of long lines take time, and are asked for again and again.
std::vector<Pose> endsOf(const std::vector<Leg>& legs);

struct FinishedLegs {
    std::vector<Leg> legs;
    std::vector<HeadlandPass> put;
    std::vector<HeadlandPass> refused;  ///< no way in or out was found
};

/// The same legs with short passes in between, each where it adds least time of the places near it, and in
/// the direction that does, with ways that are quickly found. When all are placed, each is placed once more
/// among the others.
FinishedLegs withFinishingPasses(std::vector<Leg> legs, const std::vector<HeadlandPass>& passes,
                                 RememberedWays& ways, const Machine& machine, const JobContext& job);

}  // namespace furrow
