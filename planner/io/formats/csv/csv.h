#pragma once

#include "planner/io/content/format_parts.h"

#include <string>
#include <string_view>

namespace furrow {

/// path.csv with the path of a plan; of fields alone fields.csv with the columns id, name and WKT.
FormatWriter writeCsv;
ContentFinder findCsv;

/// Any text may be a table with a header.
FormatRecogniser recogniseTrackTable;
TrackReader readTrackTable;

/// The same of the text itself; `where` names it in messages.
Result<TrackFile> tableTracks(std::string_view text, const std::string& where, const JobContext& job);

}  // namespace furrow
