#pragma once

#include "planner/core/result.h"
#include "planner/headland/headland.h"
#include "planner/headland/pass_task.h"

#include <functional>
#include <vector>

namespace furrow {

/// The passes along the edges of a region, in stretches. They are cut at corners where rounding would leave
/// an area between two passes. They are extended into those corners as far as the machine stays inside.
/// @param gentle  distance before a corner at which its bend begins if there is room
std::vector<HeadlandPass> passesOn(const MultiPolygon& region, const PassTask& task, int ring, Length gentle);

/// Passes inside the outermost one, which gives them room to turn. Each follows the edge with its corners
/// kept sharp, in stretches that reach into the corners. So nothing is left between one pass and the next.
///
/// @param inset  from the edges of the field to the middle of the pass
/// Cost: one GEOS buffer. Cancelled.
Result<std::vector<HeadlandPass>> innerPasses(const PassTask& task, Length inset, int ring,
                                              const JobContext& job);

/// The parts of passes that belong to some strips only. Both ends are extended as far as land is left and the
/// machine stays in the field.
/// @param belongs  whether a place of a pass is in one of those strips
/// @param isLeft   whether no other pass works a place
std::vector<HeadlandPass> partsOf(const std::vector<HeadlandPass>& passes,
                                  const std::function<bool(Point)>& belongs,
                                  const std::function<bool(Point)>& isLeft, const PassTask& task);

/// Straight passes along strips narrower than one operating width at the place of the next pass, for example
/// the middle of an arm of the field.
/// @param inset  from the edges of the field to the end of the passes before. Cost: two GEOS buffers.
/// Cancelled.
Result<std::vector<HeadlandPass>> passesAlongStrips(const PassTask& task, Length inset, int ring,
                                                    const JobContext& job);

}  // namespace furrow
