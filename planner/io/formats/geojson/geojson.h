#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// plan.geojson; of fields alone their features, mainland and guidance lines.
FormatWriter writeGeoJson;
ContentFinder findGeoJson;

}  // namespace furrow
