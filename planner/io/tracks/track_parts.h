#pragma once

// The readers behind readTracks, one for each format, and what they share.

#include "planner/core/result.h"
#include "planner/io/files/file_folder.h"
#include "planner/jobs/job.h"
#include "planner/track/recorded_track.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace furrow {

/// A month of positions ten times a second is 26 million; a field day is under a million.
inline constexpr std::size_t kMostTrackSamples = 5'000'000;

Result<TrackFile> gpxTracks(std::string_view text, const std::string& where, const JobContext& job);
Result<TrackFile> tableTracks(std::string_view text, const std::string& where, const JobContext& job);
Result<TrackFile> gpsdTracks(std::string_view text, const std::string& where, const JobContext& job);
Result<TrackFile> nmeaTracks(std::string_view text, const std::string& where, const JobContext& job);
/// All time logs beside the TASKDATA.XML of this folder or zip.
Result<TrackFile> isoxmlTracks(const FileFolder& folder, const std::string& where, const JobContext& job);
/// Of one or more files of one bag, in their order.
Result<TrackFile> rosbagTracks(const std::vector<std::filesystem::path>& files, const std::string& where,
                               const JobContext& job);

/// Whether the text looks like one of these, told by its first kilobytes.
bool looksLikeGpsd(std::string_view start);
bool looksLikeNmea(std::string_view start);

Error trackRefused(const std::string& where, std::string what, std::string remedy);
Error trackDamaged(const std::string& where, std::string what);
Error tooManySamples(const std::string& where);

/// A finite longitude and latitude in their ranges.
bool isOnEarth(double lonDeg, double latDeg);
/// From degrees clockwise from north to radians counter-clockwise from east, in [0, 2 pi).
double headingFromBearing(double bearingDeg);
/// "2020-10-26T19:47:55.5Z", with a blank instead of the T, with "+02:00"; without a zone it is UTC.
std::optional<double> utcSeconds(std::string_view text);
/// Days from 1970-01-01 to a date of the Gregorian calendar, in seconds; nothing for no date.
std::optional<double> utcMidnight(int year, unsigned month, unsigned day);
/// The whole text as a number, blanks around it allowed, "nan" and "inf" among them.
std::optional<double> numberIn(std::string_view text, bool decimalComma = false);
std::string_view trimmed(std::string_view text);

/// The lines of a text without their ends, one after the other.
class Lines {
public:
    explicit Lines(std::string_view text);
    bool next(std::string_view& line);
    std::size_t number() const { return number_; }  ///< of the last one, from 1

private:
    std::string_view rest_;
    std::size_t number_ = 0;
};

/// "12 lines without a position were passed over", unless there was none.
void noteSkipped(TrackFile& file, std::size_t count, std::string_view what, const std::string& where);

}  // namespace furrow
