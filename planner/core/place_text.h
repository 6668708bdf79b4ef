#pragma once

#include "planner/core/geo_point.h"

#include <optional>
#include <string_view>

namespace furrow {

/// The place that a text names by its latitude and longitude in WGS84, as maps, phones and receivers write
/// it: "48.1371, 11.5754", "48,1371; 11,5754", "N 48.1371 E 11.5754", "48° 8' 13.6\" N, 11° 34' 31\" E", "48
/// 08.226 N 11 34.524 E", "geo:48.1371,11.5754". Latitude first, unless letters (N, S, E, W) say otherwise.
/// Nothing where the text is anything else, or the place is none on Earth.
std::optional<GeoPoint> placeNamedBy(std::string_view text);

}  // namespace furrow
