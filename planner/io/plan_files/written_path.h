#pragma once

#include "planner/core/result.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/polygon.h"
#include "planner/path/path.h"
#include "planner/units/quantity.h"

#include <filesystem>
#include <string>

namespace furrow {

/// What a written plan says of its path: enough to lay something over it.
struct WrittenPath {
    std::string name;  ///< of the field
    LocalFrame frame;
    Path path;
    MultiPolygon field;      ///< as drawn
    MultiPolygon obstacles;  ///< as drawn
    Length operatingWidth;
};

/// Reads summary.json (frame, machine, name), path.csv (the path, to the last bit) and plan.geojson (field
/// and obstacles) of a plan's folder. A plan written without plan.geojson has no field and no obstacles.
///
/// @return ReadFailed: a folder or file is missing or cannot be read. InputRefused, naming the file and the
///         place in it: damaged.
Result<WrittenPath> readWrittenPath(const std::filesystem::path& folder);

}  // namespace furrow
