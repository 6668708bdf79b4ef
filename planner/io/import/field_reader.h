#pragma once

#include "planner/core/result.h"
#include "planner/io/content/imported_fields.h"
#include "planner/jobs/job.h"

#include <filesystem>

namespace furrow {

/// Reads fields with everything that belongs to them. The format is told by the content:
/// - ISOXML 3 and 4: TASKDATA.XML in any spelling, its folder, or a zip with or without a folder; parts in
/// files of
///   their own are found beside it. What a schema would refuse is read where its meaning is clear;
/// - AgOpenGPS: a field's folder, one of its files, a folder or zip of several fields;
/// - AgGPS: the folder, with the swaths that lie beside each boundary;
/// - rasters (GeoTIFF, PNG with a world file): what is worked and what is not;
/// - every other format of readBoundaries, with lines and mainland where the file says what they are.
///
/// @return at least one field or line. Errors as readBoundaries. Nothing is written, nothing is fetched from
/// a
///         network, and no name inside a file or zip leads out of it.
Result<ImportedFields> readFields(const std::filesystem::path& path, const JobContext& job = {});

}  // namespace furrow
