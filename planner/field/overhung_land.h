#pragma once

#include "planner/field/field.h"

#include <optional>

namespace furrow {

/// The area in which an implement may stand: the drivable area, the land outside each edge up to its overhang
/// with round ends, and the rim of each obstacle up to its overhang. Where edges differ, the one with less
/// overhang keeps the land in front of it.
/// @param least  overhang of every edge and obstacle; what the field gives counts where it is more
/// Empty if there is no overhang anywhere: it is then the drivable area. Cancelled. Cost: GEOS buffers and
/// overlays, and edges times edges with more overhang.
Result<std::optional<MultiPolygon>> overhungLand(const Field& field, Length least, const JobContext& job);

}  // namespace furrow
