#pragma once

#include "planner/geometry/point.h"

#include <cstddef>
#include <vector>

namespace furrow {

/// Heights on a square grid in the local frame, row after row from the south, each from the west. Not finite
/// where nothing is known.
struct ElevationGrid {
    Point origin;  ///< the first, south-western, value's place
    double cellM = 1.0;
    std::size_t columns = 0;
    std::size_t rows = 0;
    std::vector<double> heightsM;

    double at(std::size_t column, std::size_t row) const { return heightsM[row * columns + column]; }
};

}  // namespace furrow
