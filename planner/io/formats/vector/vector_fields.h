#pragma once

#include "planner/io/content/format_parts.h"

#include <filesystem>
#include <vector>

namespace furrow {

/// Fields of a file that GDAL reads; see readFields and readBoundaries. A drawing's layers say what is in
/// them by their names; recorded tracks that come back to where they began are closed, with a note.
Result<ImportedFields> vectorFields(const std::filesystem::path& path, const JobContext& job);

/// Every line of such a file as a guidance line.
Result<std::vector<GuidanceLine>> vectorLines(const std::filesystem::path& path, const JobContext& job);

/// Every file that no other format knows better: GDAL tells its formats apart by opening them.
FormatRecogniser recogniseVector;
FieldReader readVectorFields;

}  // namespace furrow
