#pragma once

#include "ui/map/map_frame.h"

#include <span>
#include <vector>

namespace furrow {

/// The line with fewer points, nowhere further than `tolerance` units from it; its ends stay.
///
/// Source: D. H. Douglas, T. K. Peucker, Algorithms for the reduction of the number of points required to
/// represent a digitized line or its caricature, 1973, doi 10.3138/FM57-6770-U75U-7727.
/// Cost: O(n log n) as a rule, O(n²) at worst.
std::vector<MapPoint> simplified(std::span<const MapPoint> line, float tolerance);

}  // namespace furrow
