#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// plan.gpkg with the layers of mapLayers.
FormatWriter writeGeoPackage;
ContentFinder findGeoPackage;

}  // namespace furrow
