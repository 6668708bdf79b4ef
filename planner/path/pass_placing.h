#pragma once

#include "planner/headland/full_lock_passes.h"
#include "planner/headland/headland.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"

#include <vector>

namespace furrow {

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
/// the direction that does, with ways that are quickly found.
FinishedLegs withFinishingPasses(std::vector<Leg> legs, const std::vector<HeadlandPass>& passes,
                                 RememberedWays& ways, const Machine& machine, const JobContext& job);

}  // namespace furrow
