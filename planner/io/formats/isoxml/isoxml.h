#pragma once

#include "planner/io/content/format_parts.h"

#include <string>

namespace furrow {

/// TASKDATA.XML in any spelling, its folder, or a zip with or without a folder. A file has to say that it is
/// task data.
FormatRecogniser recogniseIsoxml;
FieldReader readIsoxmlFields;

/// TASKDATA/TASKDATA.XML, in version 4 with LINKLIST.XML beside it.
FormatWriter writeIsoxml4;
FormatWriter writeIsoxml3;
ContentFinder findIsoxml;

/// Any folder or zip, and TASKDATA.XML; the time logs lie beside it.
FormatRecogniser recogniseTimeLogs;
TrackReader readTimeLogs;

/// All time logs beside the TASKDATA.XML of this folder or zip.
Result<TrackFile> isoxmlTracks(const FileFolder& folder, const std::string& where, const JobContext& job);

}  // namespace furrow
