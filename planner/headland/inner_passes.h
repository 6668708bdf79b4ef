#pragma once

#include "planner/core/result.h"
#include "planner/headland/headland.h"

#include <vector>

namespace furrow {

/// Passes inside of the outermost one. They have its room to turn in: each follows the edge with its corners kept
/// sharp, in stretches that reach into them, so that nothing is left between one pass and the next.
///
/// @param inset  from the edges of the field to the middle of the pass
/// Cost: one GEOS buffer. Cancelled.
Result<std::vector<HeadlandPass>> innerPasses(const HeadlandTask& task, Length inset, int ring, bool clockwise,
                                              const JobContext& job);

/// Straight passes along what is narrower than one operating width where the next pass would run: the middle of
/// an arm of the field, say.
/// @param inset  from the edges of the field to where the passes before end. Cost: two GEOS buffers. Cancelled.
Result<std::vector<HeadlandPass>> passesAlongStrips(const HeadlandTask& task, Length inset, int ring,
                                                    const JobContext& job);

}  // namespace furrow
