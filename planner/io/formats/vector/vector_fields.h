#pragma once

#include "planner/io/import/field_reader.h"

namespace furrow {

/// Fields of a file that GDAL reads; see readFields and readBoundaries. A drawing's layers say what is in them by
/// their names; recorded tracks that come back to where they began are closed, with a note.
Result<ImportedFields> vectorFields(const std::filesystem::path& path, const JobContext& job);

/// Every line of such a file as a guidance line.
Result<std::vector<GuidanceLine>> vectorLines(const std::filesystem::path& path, const JobContext& job);

}  // namespace furrow
