#pragma once

#include "planner/plan/stages.h"

#include <cstddef>
#include <span>

namespace furrow {

/// Seconds: the driven path, and what it leaves within the field worked by itself. Areas that are left on
/// purpose cost nothing.
Duration timeForAll(const Machine& machine, const Path& path, const AuditReport& audit);

/// The best plan so far. Another one is of use only if less stands in its way, or as much and it takes less
/// time.
struct PlanToBeat {
    std::ptrdiff_t blocking = 0;  ///< findings
    Duration time;                ///< for all
    /// By how much finishing passes made it longer, beyond the time for the land that they work.
    Duration finishing;
    Area left;  ///< within reach, before them
};

PlanToBeat planToBeat(const Machine& machine, const Driven& driven);

/// Never told, so without words: a better plan is there.
Error noBetter(const Field& field);

/// Findings that block, and that no finishing pass mends.
std::ptrdiff_t lastingCount(std::span<const Finding> findings);

/// Whether a plan with this path, which no obstacle gets a headland in after all, may be better. What it
/// misses has to be worked, too, by finishing passes or by itself.
/// @param audit  empty before it
bool mayBeat(const PlanToBeat& other, const Machine& machine, const Driven& driven);

/// The same of a plan that needs finishing passes. As much land costs them at least a quarter of what it
/// cost those of the plan to beat. A plan that is slower by more than 1 % even so may not.
/// Cost: none to speak of.
bool mayBeatFinished(const PlanToBeat& other, const Machine& machine, const Driven& unfinished);

}  // namespace furrow
