#pragma once

#include "planner/core/result.h"
#include "planner/io/delivery/plan_folder.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace furrow {

/// Writes fields without a plan.
///
/// @param out       a file, whose name says the format where none is given, or a folder for formats of
/// several files:
///                  TASKDATA and AgGPS say theirs. Of a shapefile the boundary has the given name, other
///                  layers theirs behind it. A drawing gets the code of its coordinate system into its name.
///                  Formats of several files end up in a zip where the name ends in .zip.
/// @param formatId  any that writes fields
/// @return Usage: no format, or one that holds plans only. InputRefused, WriteFailed, Cancelled as
/// writePlanFolder.
Result<WrittenFiles> writeFields(std::span<const FieldContent> fields, const std::filesystem::path& out,
                                 std::optional<std::string_view> formatId, const ExportOptions& options = {},
                                 const JobContext& job = {});

}  // namespace furrow
