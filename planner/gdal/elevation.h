#pragma once

#include "planner/core/result.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/elevation_grid.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <filesystem>

namespace furrow {

/// Heights around a field from a raster on this computer, in any coordinate system, interpolated onto a grid
/// in the local frame that is as fine as the raster, but no finer than a metre and no more than 1024 cells
/// along a side.
///
/// @param path  GeoTIFF, ASCII grid, SRTM or DTED; the first band, in metres
/// @param box   what has to be covered
/// @return ReadFailed: not there, no known format, damaged. InputRefused: no coordinate system, or the raster
/// has no
///         height anywhere in the box. Cancelled: asked by GDAL between blocks.
Result<ElevationGrid> readElevation(const std::filesystem::path& path, const LocalFrame& frame,
                                    const Bounds& box, const JobContext& job);

}  // namespace furrow
