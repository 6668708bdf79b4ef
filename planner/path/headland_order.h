#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/headland/headland.h"
#include "planner/path/path_builder.h"

#include <functional>
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
    /// The time of the way in the field, of several moves where no single curve fits, if there is one.
    /// Empty: only single curves are compared.
    std::function<std::optional<Duration>(const Pose& leaving, const Pose& arriving)> searched = {};
};

/// The legs of all passes, ring by ring around each boundary or obstacle, nearest first. Each closed pass
/// starts where the way from the pass before, or to the pass after, is quickest. Cost: a few hundred turns
/// for each pass, and up to four searches where no single curve of a short way fits.
std::vector<Leg> headlandLegs(const std::vector<HeadlandPass>& passes, const HeadlandDrive& drive,
                              const Machine& machine, TurnPlanner* turn);

/// The leg of one stretch of a pass.
Leg legOf(const HeadlandPass& pass, const PassStretch& stretch);

}  // namespace furrow
