#pragma once

#include "planner/io/import/field_reader.h"

#include <string_view>

namespace furrow {

/// Whether a file that starts like this is a TIFF or PNG.
bool looksLikeRaster(std::string_view start);

/// A raster whose pixels are worked (not 0, not the file's value for nothing, not transparent) or not: a GeoTIFF, or
/// a PNG with a world file in longitude and latitude or with an .aux.xml that names its system. Each patch of at
/// least a hundredth of the largest and 100 m² is a part of one field, what it encloses that is not worked a hole;
/// smaller ones are counted in a note. Outlines follow the pixels and are smoothed by at most three quarters of one.
///
/// @return one field. ReadFailed: damaged. InputRefused: no place on Earth, above 100 million pixels, nothing worked.
///         Cost: linear in the pixels.
Result<ImportedFields> readRasterMask(const std::filesystem::path& path, const JobContext& job);

}  // namespace furrow
