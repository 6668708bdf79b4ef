#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// TIFF or PNG, by its first bytes.
FormatRecogniser recogniseRaster;

/// A raster whose pixels are worked or not (see workedPatches): a GeoTIFF, or a PNG with a world file in
/// longitude and latitude or with an .aux.xml that names its system. Each patch of at least a hundredth of
/// the largest and 100 m² is a part of one field; smaller ones are counted in a note.
///
/// @return one field. InputRefused: also where nothing is worked.
FieldReader readRasterMask;

}  // namespace furrow
