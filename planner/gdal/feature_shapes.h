#pragma once

#include "planner/core/message.h"
#include "planner/core/result.h"
#include "planner/gdal/to_wgs84.h"
#include "planner/gdal/vector_feature.h"

#include <string>

namespace furrow {

/// Adds the points, lines and areas of a geometry to a feature, of a collection those of its members, curves
/// as short chords.
///
/// @return InputRefused: see checkDegrees, where the coordinate system is not known.
Result<void> addShapes(const OGRGeometry& geometry, const ToWgs84& toWgs84, VectorFeature& feature,
                       const std::string& where);

}  // namespace furrow
