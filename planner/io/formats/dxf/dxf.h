#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// plan_EPSG<code>.dxf (R12): polylines in metres of the field's UTM zone, layers BOUNDARY, HOLE, OBSTACLE,
/// HEADLAND, SWATH and PATH.
FormatWriter writeDxf;
ContentFinder findDxf;

}  // namespace furrow
