#pragma once

#include "planner/headland/headland.h"

namespace furrow {

/// So many passes and what the outermost leaves beside the edge; the margin alone for none.
Length widthOfPasses(int passes, const HeadlandTask& task);
/// How many passes a width holds.
int passesWithin(Length width, const HeadlandTask& task);
/// A width as it is laid out: of a headland that is driven, what its passes work, since more would be driven over twice
/// or left; otherwise as given.
Length heldWidth(Length given, const HeadlandTask& task);
/// The fewest that are as wide as this, at least one.
int passesFor(Length room, const Machine& machine);

/// The headland that is wanted, less where the field is too narrow for it: fewer passes, in the end none.
/// @param wanted  its width, passes and strips; those of edges for which the field says a width get that
/// InputRefused: nothing of the field is left. Cancelled. Cost: GEOS buffers for the mainland and for each pass.
Result<Headland> headlandOf(Headland wanted, const HeadlandTask& task, const JobContext& job);

}  // namespace furrow
