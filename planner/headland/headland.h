#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/settings.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// The strip kept for turning and what is left inside it.
struct Headland {
    Length width;                ///< from the boundary; 0 without a headland
    int passes = 0;              ///< operating widths that fit into it
    MultiPolygon mainland;       ///< the field without headland, in metres
    double mainlandRatio = 0.0;  ///< A_r = area(mainland) / area(field)
    std::vector<Note> notes;     ///< what was given up, and why
};

/// InputRefused: the margin alone leaves nothing of the field.
Error nothingLeft(Length margin);

/// The common signature of all headland methods.
///
/// @param field     a checked field
/// @param machine   for widths and the room its turns need
/// @param turn      how it will turn
/// @param margin    what everything keeps from the boundary
/// @return a headland whose mainland is not empty. InputRefused: nothing of the field is left. Cancelled.
using HeadlandGenerator = Result<Headland>(const Field& field, const Machine& machine, TurnPlanner* turn,
                                           const Settings& settings, Length margin, const JobContext& job);

}  // namespace furrow
