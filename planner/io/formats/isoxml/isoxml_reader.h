#pragma once

#include "planner/core/result.h"
#include "planner/io/content/imported_fields.h"
#include "planner/io/files/file_folder.h"

#include <functional>
#include <string>
#include <string_view>

namespace furrow {

/// The parts of a task data set that lie in files of their own (XFR): given a name such as "PFD00001", its
/// text.
using IsoxmlPart = std::function<Result<std::string>(const std::string& name)>;

/// The fields of ISO 11783-10 task data, version 3 or 4, whatever its version says: boundaries (kinds 1 and
/// 9), holes as inner rings, water, buildings, obstacles and windbreaks as obstacles, other areas as
/// obstacles that may be driven on, the headland polygon as mainland, points of access as gates, guidance
/// patterns and lines. What is not read is counted in a note. A number that is no plain decimal leaves out
/// the ring or line it stands in.
///
/// @return ReadFailed: no XML. InputRefused: no task data, no field in it, over 64 parts. Cost: linear.
Result<ImportedFields> readIsoxml(std::string_view xml, const std::string& where, const IsoxmlPart& part,
                                  const JobContext& job);

/// Of the main file of a folder or zip, whose parts lie beside it.
Result<ImportedFields> readIsoxmlFolder(const FileFolder& folder, const FileFolder::Entry& main,
                                        const JobContext& job);

/// Whether a file that starts like this is task data.
bool looksLikeIsoxml(std::string_view start);

}  // namespace furrow
