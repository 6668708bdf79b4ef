#include "planner/io/import/track_reader.h"

#include "planner/io/files/chosen_file.h"
#include "planner/io/formats/registry.h"
#include "planner/io/tracks/track_parts.h"

namespace furrow {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRemedy =
    "give GPX, CSV, an NMEA or gpsd log, ISOXML task data (folder, TASKDATA.XML or zip) or a rosbag2";

Error noTrack(const ChosenFile& chosen) {
    if (!chosen.isXml()) {
        return trackRefused(chosen.path().string(), "this is no track that can be read", kRemedy);
    }
    const std::string root = chosen.xmlRoot();
    return trackRefused(chosen.path().string(),
                        root.empty() ? Message{"this XML file is cut off"}
                                     : message("'{}' files hold no recorded track", root),
                        kRemedy);
}

}  // namespace

Result<TrackFile> readTracks(const fs::path& path, const JobContext& job) {
    const std::string text = path.string();
    if (text.find("://") != std::string::npos || text.starts_with("/vsi")) {
        return std::unexpected(Error{.code = ErrorCode::ReadFailed,
                                     .what = "only files on this computer are read",
                                     .where = text,
                                     .remedy = "download the file and give its path"});
    }
    const ChosenFile chosen{path, kTrackStartBytes, kDeepestTrack};
    if (!chosen.isDirectory() && !chosen.start()) {
        return std::unexpected(chosen.start().error());
    }
    const Format* format = recognisedAsTracks(chosen).format;
    return format != nullptr ? format->tracks.read(chosen, job) : std::unexpected(noTrack(chosen));
}

}  // namespace furrow
