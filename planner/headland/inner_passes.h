#pragma once

#include "planner/core/result.h"
#include "planner/headland/headland.h"
#include "planner/headland/pass_task.h"

#include <functional>
#include <vector>

namespace furrow {

/// The passes along the edges of a region, in stretches: cut at corners where rounding would leave something between
/// two passes, and drawn out into those corners as far as the machine stays inside.
/// @param gentle  bends begin so far before their corner where there is room
std::vector<HeadlandPass> passesOn(const MultiPolygon& region, const PassTask& task, int ring, Length gentle);

/// Passes inside of the outermost one. They have its room to turn in: each follows the edge with its corners kept
/// sharp, in stretches that reach into them, so that nothing is left between one pass and the next.
///
/// @param inset  from the edges of the field to the middle of the pass
/// Cost: one GEOS buffer. Cancelled.
Result<std::vector<HeadlandPass>> innerPasses(const PassTask& task, Length inset, int ring, const JobContext& job);

/// The parts of passes that belong to some strips only, drawn out on both sides as far as something is left and the
/// machine does not leave the field.
/// @param belongs  whether a place of a pass is in one of those strips
/// @param isLeft   whether nothing else works a place
std::vector<HeadlandPass> partsOf(const std::vector<HeadlandPass>& passes, const std::function<bool(Point)>& belongs,
                                  const std::function<bool(Point)>& isLeft, const PassTask& task);

/// Straight passes along what is narrower than one operating width where the next pass would run: the middle of
/// an arm of the field, say.
/// @param inset  from the edges of the field to where the passes before end. Cost: two GEOS buffers. Cancelled.
Result<std::vector<HeadlandPass>> passesAlongStrips(const PassTask& task, Length inset, int ring,
                                                    const JobContext& job);

}  // namespace furrow
