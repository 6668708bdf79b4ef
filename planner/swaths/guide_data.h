#pragma once

#include "planner/geometry/elevation_grid.h"
#include "planner/geometry/polygon.h"

#include <optional>
#include <vector>

namespace furrow {

/// Guides for swaths from separate files, in the field's local frame.
struct GuideData {
    std::vector<Polyline> rows;              ///< in the order of the file
    std::optional<ElevationGrid> elevation;  ///< around the field
};

}  // namespace furrow
