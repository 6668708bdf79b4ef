#pragma once

#include "planner/geometry/polygon.h"
#include "planner/swaths/guide_data.h"

#include <optional>
#include <vector>

namespace furrow {

/// The height at a place, bilinear; nothing outside of the grid or beside unknown cells.
std::optional<double> heightAt(const ElevationGrid& grid, Point place);

/// Heights with bumps smaller than `radius` evened out (Gaussian, its standard deviation); unknown cells stay unknown.
/// Cost: O(cells · radius / cell).
ElevationGrid smoothed(const ElevationGrid& grid, Length radius);

/// The lines of one height (marching squares; Lorensen & Cline 1987, doi 10.1145/37402.37422, in the plane), uphill to
/// their left; closed ones end where they begin. Cost: O(cells).
std::vector<Polyline> contourLines(const ElevationGrid& grid, double heightM);

}  // namespace furrow
