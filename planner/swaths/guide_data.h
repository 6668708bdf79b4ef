#pragma once

#include "planner/geometry/polygon.h"

#include <optional>
#include <vector>

namespace furrow {

/// Heights on a square grid in the local frame: rows from the south, each from the west. Unknown heights are
/// not finite.
struct ElevationGrid {
    Point origin;  ///< place of the first, south-western, value
    double cellM = 1.0;
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<double> heightsM;

    double at(std::size_t column, std::size_t row) const { return heightsM[row * columns + column]; }
};

/// Guides for swaths from separate files, in the field's local frame.
struct GuideData {
    std::vector<Polyline> rows;              ///< in the order of the file
    std::optional<ElevationGrid> elevation;  ///< around the field
};

}  // namespace furrow
