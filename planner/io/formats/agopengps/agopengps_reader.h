#pragma once

#include "planner/core/result.h"
#include "planner/io/content/imported_fields.h"
#include "planner/io/files/file_folder.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace furrow {

/// Given the name of a file in a field's folder, its text; nothing where it is not there.
using AgOpenGpsFile = std::function<std::optional<std::string>(std::string_view name)>;

/// A field folder of AgOpenGPS: Field.txt for its place, Boundary.txt with holes (those marked as
/// drive-through are obstacles that may be driven on), Headland.txt as mainland, TrackLines.txt (older:
/// ABLines.txt, CurveLines.txt) as guidance lines, RecPath.txt as a curve driven once. A file that is damaged
/// is left out with a note; decimal commas in Field.txt are read and told.
///
/// @param name  of the field: that of its folder
/// @return InputRefused: no place, a boundary that cannot be read. Cost: linear.
Result<ImportedFields> readAgOpenGps(const std::string& name, const AgOpenGpsFile& file);

/// All field folders in a folder or zip.
Result<ImportedFields> readAgOpenGpsFolder(const FileFolder& folder, const std::string& name,
                                           const JobContext& job);

}  // namespace furrow
