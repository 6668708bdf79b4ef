#pragma once

#include "planner/headland/full_lock_passes.h"
#include "planner/headland/headland.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"
#include "planner/turns/rig.h"

#include <vector>

namespace furrow {

/// Whether a pass may be driven between two of the legs near it. Looks for ways that are quickly found.
/// @param ends  of the legs, by endsOf
PassAccess accessTo(const Curve& line, const std::vector<Leg>& legs, const std::vector<Pose>& ends,
                    RememberedWays& ways, const JobContext& job);

/// The poses at which the legs end. Those of long lines take time, and are asked for again and again.
std::vector<Pose> endsOf(const std::vector<Leg>& legs);

/// Whether a headland pass is so short that its place among the legs may be anywhere.
bool isShortPass(const HeadlandPass& pass);

struct PlacedPasses {
    std::vector<Leg> legs;
    std::vector<HeadlandPass> put;
    std::vector<HeadlandPass> refused;  ///< no way in or out was found
};

/// The same legs with short passes in between, each where it adds least time of the places near it, and in
/// the direction that does, with ways that are quickly found.
PlacedPasses withPassesBetween(std::vector<Leg> legs, const std::vector<HeadlandPass>& passes,
                               RememberedWays& ways, const Machine& machine, const JobContext& job);

/// The same legs with short headland passes at other places among them, or in the other direction, where the
/// ways to a pass and on from it are much quicker.
///
/// @param lowered  the rig for driving a pass, implement down
/// Cost: lookups if the ways between the legs were found before; some quick searches for each pass with long
/// ways.
std::vector<Leg> withShortPassesMoved(std::vector<Leg> legs, RememberedWays& ways, const Rig& lowered,
                                      const JobContext& job);

}  // namespace furrow
