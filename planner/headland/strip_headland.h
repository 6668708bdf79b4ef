#pragma once

#include "planner/headland/headland.h"

namespace furrow {

/// The width of this many passes and of the strip that the outermost leaves beside the edge. For 0 passes,
/// the margin alone.
Length widthOfPasses(int passes, const HeadlandTask& task);
/// The number of passes that fit into a width.
int passesWithin(Length width, const HeadlandTask& task);
/// The width that is laid out. A driven headland gets the width that its passes work: more would be driven
/// over twice or left. Otherwise the width is as given.
Length heldWidth(Length given, const HeadlandTask& task);
/// The fewest passes that are as wide as this, at least one.
int passesFor(Length room, const Machine& machine);

/// The wanted headland, or less if the field is too narrow for it: fewer passes, finally none.
/// @param wanted  its width, passes and strips; edges with a width in the field get that width
/// InputRefused: nothing of the field is left. Cancelled. Cost: GEOS buffers for the mainland and each pass.
Result<Headland> headlandOf(Headland wanted, const HeadlandTask& task, const JobContext& job);

}  // namespace furrow
