#pragma once

#include "planner/geometry/polygon.h"

#include <string_view>

namespace furrow::test {

/// The rings of a POLYGON or MULTIPOLYGON as they are written, valid or not, so that a row of a test can be
/// pasted into a viewer. A closing point that repeats the first one is left out.
MultiPolygon polygonsFromWkt(std::string_view wkt);

/// The same with closing points kept, as files have them.
MultiPolygon polygonsAsInFile(std::string_view wkt);

/// The points of a LINESTRING.
Polyline lineFromWkt(std::string_view wkt);

}  // namespace furrow::test
