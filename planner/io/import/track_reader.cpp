#include "planner/io/import/track_reader.h"

#include "planner/core/text_file.h"
#include "planner/io/tracks/track_parts.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <format>
#include <vector>

namespace furrow {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kRemedy =
    "give GPX, CSV, an NMEA or gpsd log, ISOXML task data (folder, TASKDATA.XML or zip) or a rosbag2";
constexpr std::string_view kMcapMagic = "\x89MCAP";
constexpr std::string_view kSqliteMagic = "SQLite format 3";

bool isBagFile(const fs::path& path) {
    const std::string extension = extensionInSmallLetters(path);
    return extension == ".db3" || extension == ".mcap";
}

/// A later piece of a bag has a larger number at its end: x_2.db3 before x_10.db3.
std::vector<fs::path> bagFilesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::directory_iterator it{folder, failed}, end; !failed && it != end; it.increment(failed)) {
        if (isBagFile(it->path()) && it->is_regular_file(failed)) {
            files.push_back(it->path());
        }
    }
    std::ranges::sort(files, {}, [](const fs::path& file) {
        const std::string name = file.filename().string();
        return std::pair{name.size(), name};
    });
    return files;
}

Result<TrackFile> readFolder(const fs::path& path, const JobContext& job) {
    const std::vector<fs::path> bag = bagFilesIn(path);
    if (!bag.empty()) {
        return rosbagTracks(bag, path.string(), job);
    }
    const auto folder = FileFolder::open(path);
    if (!folder) {
        return std::unexpected(folder.error());
    }
    return isoxmlTracks(*folder, path.string(), job);
}

/// The name of the first element of an XML text; empty where it is none.
std::string rootOfXml(std::string_view text) {
    std::size_t at = 0;
    while ((at = text.find('<', at)) != std::string_view::npos && at + 1 < text.size()) {
        if (text.substr(at).starts_with("<!--")) {
            at = text.find("-->", at);
            if (at == std::string_view::npos) {
                return {};
            }
        } else if (text[at + 1] == '?' || text[at + 1] == '!') {
            ++at;
        } else {
            const std::size_t end = text.find_first_of(" \t\r\n/>", at + 1);
            return std::string{text.substr(at + 1, end == std::string_view::npos ? end : end - at - 1)};
        }
    }
    return {};
}

Result<TrackFile> readXml(const fs::path& path, std::string_view start, const JobContext& job) {
    const std::string root = rootOfXml(start);
    if (root == "ISO11783_TaskData" || root == "TIM") {
        // The logs lie beside it; what is in folders below belongs to others.
        const fs::path folder = fs::absolute(path).parent_path();
        const auto files = FileFolder::open(folder, 0);
        return files ? isoxmlTracks(*files, folder.string(), job) : std::unexpected(files.error());
    }
    const auto text = fileBytes(path);
    if (!text) {
        return std::unexpected(text.error());
    }
    if (root == "gpx") {
        return gpxTracks(*text, path.string(), job);
    }
    return std::unexpected(trackRefused(
        path.string(),
        root.empty() ? "this XML file is cut off" : std::format("'{}' files hold no recorded track", root),
        std::string{kRemedy}));
}

bool looksLikeText(std::string_view start) {
    return std::ranges::none_of(start, [](char letter) {
        return static_cast<unsigned char>(letter) < 0x20 && letter != '\t' && letter != '\r' &&
               letter != '\n';
    });
}

Result<TrackFile> readFile(const fs::path& path, const JobContext& job) {
    const auto start = fileStart(path, 16'384);
    if (!start) {
        return std::unexpected(start.error());
    }
    if (start->starts_with(kMcapMagic) || start->starts_with(kSqliteMagic) || isBagFile(path)) {
        return rosbagTracks({path}, path.string(), job);
    }
    if (isZip(*start)) {
        const auto zip = FileFolder::open(path);
        return zip ? isoxmlTracks(*zip, path.string(), job) : std::unexpected(zip.error());
    }
    if (start->starts_with("#ROSBAG V")) {
        return std::unexpected(trackRefused(path.string(), "this is a bag of ROS 1",
                                            "turn it into a rosbag2 with rosbags-convert"));
    }
    const std::string_view text = withoutByteOrderMark(*start);
    if (trimmed(text).starts_with('<')) {
        return readXml(path, text, job);
    }
    if (!looksLikeText(text)) {
        return std::unexpected(
            trackRefused(path.string(), "this is no track that can be read", std::string{kRemedy}));
    }
    const auto whole = fileBytes(path);
    if (!whole) {
        return std::unexpected(whole.error());
    }
    const std::string_view content = withoutByteOrderMark(*whole);
    return looksLikeGpsd(text)   ? gpsdTracks(content, path.string(), job)
           : looksLikeNmea(text) ? nmeaTracks(content, path.string(), job)
                                 : tableTracks(content, path.string(), job);
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
    std::error_code failed;
    return fs::is_directory(path, failed) ? readFolder(path, job) : readFile(path, job);
}

// --- Shared by the formats --------------------------------------------------------------------------

Error trackRefused(const std::string& where, std::string what, std::string remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = where,
            .remedy = std::move(remedy)};
}

Error trackDamaged(const std::string& where, std::string what) {
    return {.code = ErrorCode::ReadFailed,
            .what = std::move(what),
            .where = where,
            .remedy = "copy or export the recording again"};
}

Error tooManySamples(const std::string& where) {
    return trackRefused(where, std::format("it holds more than {} positions", kMostTrackSamples),
                        "cut it into the days or fields that it holds");
}

bool isOnEarth(double lonDeg, double latDeg) {
    return std::abs(lonDeg) <= 180.0 && std::abs(latDeg) <= 90.0;  // false for NaN
}

double headingFromBearing(double bearingDeg) {
    return normalisedPoseHeading(degrees(90.0 - bearingDeg)).si();
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::optional<double> numberIn(std::string_view text, bool decimalComma) {
    text = trimmed(text);
    if (text.starts_with('+')) {
        text.remove_prefix(1);
    }
    std::string withPoint;
    if (decimalComma && text.find(',') != std::string_view::npos) {
        withPoint = text;
        std::ranges::replace(withPoint, ',', '.');
        text = withPoint;
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional{value} : std::nullopt;
}

std::optional<double> utcMidnight(int year, unsigned month, unsigned day) {
    const std::chrono::year_month_day date{std::chrono::year{year}, std::chrono::month{month},
                                           std::chrono::day{day}};
    if (!date.ok()) {
        return std::nullopt;
    }
    return 86'400.0 * static_cast<double>(std::chrono::sys_days{date}.time_since_epoch().count());
}

std::optional<double> utcSeconds(std::string_view text) {
    text = trimmed(text);
    const auto digits = [&text](std::size_t at, std::size_t count) -> std::optional<unsigned> {
        unsigned value = 0;
        if (at + count > text.size()) {
            return std::nullopt;
        }
        const char* begin = text.data() + at;
        const auto [end, error] = std::from_chars(begin, begin + count, value);
        return error == std::errc{} && end == begin + count ? std::optional{value} : std::nullopt;
    };
    // 2020-10-26T19:47:55
    const auto year = digits(0, 4);
    const auto month = digits(5, 2);
    const auto day = digits(8, 2);
    const auto hour = digits(11, 2);
    const auto minute = digits(14, 2);
    const auto second = digits(17, 2);
    if (!year || !month || !day || !hour || !minute || !second || *hour > 24 || *minute > 59 ||
        *second > 60) {
        return std::nullopt;
    }
    const auto midnight = utcMidnight(static_cast<int>(*year), *month, *day);
    if (!midnight || text[4] != '-' || text[7] != '-' || text[13] != ':' || text[16] != ':') {
        return std::nullopt;
    }
    double seconds = *midnight + 3600.0 * *hour + 60.0 * *minute + *second;
    std::size_t at = 19;
    if (at < text.size() && (text[at] == '.' || text[at] == ',')) {
        double unit = 0.1;
        for (++at; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at, unit *= 0.1) {
            seconds += unit * (text[at] - '0');
        }
    }
    if (at == text.size() || text.substr(at) == "Z" || text.substr(at) == "z") {
        return seconds;
    }
    const auto zoneHours = digits(at + 1, 2);
    const bool colon = at + 3 < text.size() && text[at + 3] == ':';
    const auto zoneMinutes = digits(at + (colon ? 4 : 3), 2);
    if ((text[at] != '+' && text[at] != '-') || !zoneHours) {
        return std::nullopt;
    }
    const double zone = 3600.0 * *zoneHours + 60.0 * zoneMinutes.value_or(0);
    return text[at] == '+' ? seconds - zone : seconds + zone;
}

Lines::Lines(std::string_view text) : rest_{text} {}

bool Lines::next(std::string_view& line) {
    if (rest_.empty()) {
        return false;
    }
    const std::size_t end = rest_.find_first_of("\r\n");
    line = rest_.substr(0, end);
    if (end == std::string_view::npos) {
        rest_ = {};
    } else {
        rest_.remove_prefix(end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1));
    }
    ++number_;
    return true;
}

void noteSkipped(TrackFile& file, std::size_t count, std::string_view what, const std::string& where) {
    if (count > 0) {
        file.notes.push_back({.text = std::format("{} {} passed over", count, what), .where = where});
    }
}

}  // namespace furrow
