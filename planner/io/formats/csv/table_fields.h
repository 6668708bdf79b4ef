#pragma once

#include "planner/core/result.h"
#include "planner/gdal/vector_feature.h"

#include <string>

namespace furrow {

/// Of a table: where its rows have no shape, but longitude and latitude, rings are made of them. Rows of one
/// id and part follow each other, and where the ring changes within them a hole begins. InputRefused: a shape
/// or a place that is none, neither kind of columns.
Result<void> readTable(VectorFile& file, const std::string& name);

}  // namespace furrow
