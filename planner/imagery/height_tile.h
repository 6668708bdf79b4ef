#pragma once

#include "planner/imagery/warped_tile.h"

namespace furrow {

/// Pixels of heights around a tile that a hillshade and contour lines need.
inline constexpr int kHeightMargin = 2;

/// Shade and contour lines of a raster of heights on a tile with such a margin. The shade is GDAL's, with the
/// light from the north-west at 45 degrees; it darkens and lightens what lies beneath and leaves level ground
/// as it is. Every fifth contour line is wider.
///
/// @param heights  one band in metres, NaN where unknown; changed in doing so
/// @param stepM    between contour lines, > 0
/// @return nothing where no height is known
std::optional<TilePicture> heightTile(GDALDataset& heights, TileId id, double stepM);

/// The relief of a raster: how steep it is in the mean.
double meanSlope(GDALDataset& heights, double cellM);

/// A round number of metres, so that contour lines are some 30 pixels apart where it is as steep as this.
double contourStep(double slope, double metresPerPixel);

}  // namespace furrow
