#include "planner/io/import/recorded_drive.h"

#include "planner/io/files/chosen_file.h"
#include "planner/io/formats/registry.h"
#include "planner/io/import/track_reader.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

bool tellsOfDriving(const TrackSample& sample) {
    return sample.timeS || sample.speedMps || sample.headingRad || sample.implementDown;
}

bool isClosed(const RecordedTrack& track) {
    return track.samples.size() > 3 && track.samples.front().geo == track.samples.back().geo;
}

}  // namespace

std::optional<TrackFile> recordedDrive(const std::filesystem::path& path, const JobContext& job) {
    const ChosenFile chosen{path, kTrackStartBytes, kDeepestTrack};
    const RecognisedFormat tracks = recognisedAsTracks(chosen);
    const bool isJson = tracks.how == Recognition::Perhaps && chosen.text().starts_with('{');
    if (tracks.format == nullptr || isJson || recognisedAsFields(chosen).how > Recognition::Perhaps) {
        return std::nullopt;
    }
    auto read = readTracks(path, job);
    if (!read) {
        return std::nullopt;
    }
    const bool isTable = tracks.format->id == "csv";
    const bool isGpx = tracks.format->id == "gpx";
    const bool tells = std::ranges::any_of(read->tracks, [](const RecordedTrack& track) {
        return std::ranges::any_of(track.samples, tellsOfDriving);
    });
    const bool isRecorded =
        (!isTable && !isGpx) || tells || (isGpx && std::ranges::none_of(read->tracks, isClosed));
    return isRecorded ? std::optional{*std::move(read)} : std::nullopt;
}

}  // namespace furrow
