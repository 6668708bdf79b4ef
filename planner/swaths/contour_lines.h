#pragma once

#include "planner/geometry/polygon.h"
#include "planner/swaths/guide_data.h"

#include <optional>
#include <vector>

namespace furrow {

/// The height at a place, bilinear. Empty outside the grid or beside unknown cells.
std::optional<double> heightAt(const ElevationGrid& grid, Point place);

/// Heights with bumps smaller than `radius` smoothed out (Gaussian, `radius` is its standard deviation).
/// Unknown cells stay unknown. Cost: O(cells · radius / cell).
ElevationGrid smoothed(const ElevationGrid& grid, Length radius);

/// The lines of one height, with uphill to their left (marching squares in the plane; Lorensen & Cline 1987,
/// doi 10.1145/37402.37422). Closed lines end at their beginning. Cost: O(cells).
std::vector<Polyline> contourLines(const ElevationGrid& grid, double heightM);

}  // namespace furrow
