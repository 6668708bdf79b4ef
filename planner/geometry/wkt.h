#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"

#include <string>
#include <vector>

namespace furrow {

/// The points of a WKT LINESTRING or POINT. InputRefused: the text is something else.
Result<std::vector<Point>> pointsOfWkt(const std::string& wkt);

/// The places of a WKT POINT, MULTIPOINT or a collection of these. InputRefused: other text.
Result<std::vector<Point>> placesOfWkt(const std::string& wkt);

/// The lines of a WKT LINESTRING, MULTILINESTRING or a collection of these. InputRefused: other text.
Result<std::vector<Polyline>> linesOfWkt(const std::string& wkt);

}  // namespace furrow
