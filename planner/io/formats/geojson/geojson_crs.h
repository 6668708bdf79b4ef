#pragma once

#include "planner/core/result.h"

#include <string>
#include <string_view>

namespace furrow {

/// Looks at every coordinate system that a GeoJSON text names, in members `crs` and, of JSON-FG,
/// `coordRefSys`: of the collection, of features, of geometries. GDAL would fetch what a link names, and
/// where it does not understand one nothing would be left but to assume longitude and latitude.
///
/// @param text      one GeoJSON object, or of a sequence one after the other, a line or a record separator
/// between
/// @param sequence  whether it is such a sequence
/// @param name      of the file, for messages
/// @return whether the file says by a null that its system is not known. InputRefused, with the feature: one
/// that is
///         a link, one that PROJ does not know, one of a feature or geometry that is another than the file's.
/// Cost: one pass, nothing kept.
Result<bool> checkCrs(std::string_view text, bool sequence, const std::string& name);

}  // namespace furrow
