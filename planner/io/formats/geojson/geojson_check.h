#pragma once

#include "planner/core/result.h"

#include <string>
#include <string_view>

namespace furrow {

/// What GDAL leaves out of a GeoJSON text without a word: positions with something else than two numbers. NaN
/// and Infinity, which JSON does not know but GDAL reads, are left to the check of the field, which names
/// their place.
///
/// @param name    of the file, for messages
/// @param opened  GDAL could read the text; where it could not, and it is no JSON, the place is told
/// @return InputRefused: a coordinate that is no number, with its feature, part, ring and vertex. ReadFailed:
///         no JSON from some line on. Cost: one pass, nothing kept.
Result<void> checkGeoJson(std::string_view text, const std::string& name, bool opened);

}  // namespace furrow
