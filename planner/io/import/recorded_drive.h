#pragma once

#include "planner/jobs/job.h"
#include "planner/track/recorded_track.h"

#include <filesystem>
#include <optional>

namespace furrow {

/// The recording of a drive in a file or folder that was opened without saying what is in it; nothing where
/// it is to be read as boundaries, or where no track can be read.
///
/// Logs and rosbags are recordings. A table or GPX is one where a position has a time, a speed, a course or
/// the state of the implement; GPX also where none of its tracks ends where it begins. Other GPX draws
/// boundaries, as a plan's own fields do. Formats that hold fields and drives (ISOXML) are read as fields.
/// Cost: as readTracks for what may be a recording, otherwise a look into its beginning.
std::optional<TrackFile> recordedDrive(const std::filesystem::path& path, const JobContext& job = {});

}  // namespace furrow
