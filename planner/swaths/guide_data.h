#pragma once

#include "planner/geometry/elevation_grid.h"
#include "planner/geometry/polygon.h"

#include <optional>
#include <vector>

namespace furrow {

/// What swaths can follow that comes from files of its own, in the field's local frame.
struct GuideData {
    std::vector<Polyline> rows;              ///< in the order of the file
    std::optional<ElevationGrid> elevation;  ///< around the field
};

}  // namespace furrow
