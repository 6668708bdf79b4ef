#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/units/quantity.h"

#include <span>
#include <string>
#include <vector>

namespace furrow {

/// The outlines of obstacles that a file gives as points and lines: a disc around each point, a strip along
/// each line, as far as is to be kept free around them. They hold all of it, so no buffer is to be added to
/// them.
///
/// @param where  the obstacle, for messages
/// @return InputRefused, with the place: how far to keep from them is not said. Arcs are drawn to a
/// centimetre.
Result<std::vector<GeoPolygon>> outlinesAround(std::span<const GeoPoint> points,
                                               std::span<const GeoRing> lines, Length buffer,
                                               const Message& where, const JobContext& job);

}  // namespace furrow
