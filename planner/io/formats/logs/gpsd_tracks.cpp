#include "planner/core/json_text.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/formats/logs/logs.h"

#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/io/tracks/track_parts.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace furrow {

namespace {

using Json = nlohmann::json;

std::optional<double> finiteNumber(const Json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_number()) {
        return std::nullopt;
    }
    const double value = found->get<double>();
    return std::isfinite(value) ? std::optional{value} : std::nullopt;
}

/// A report of time, position and velocity; nothing where it has no fix.
std::optional<TrackSample> sampleOf(const Json& report) {
    const auto lon = finiteNumber(report, "lon");
    const auto lat = finiteNumber(report, "lat");
    if (!lon || !lat || !isOnEarth({*lon, *lat}) || finiteNumber(report, "mode").value_or(0.0) < 2.0) {
        return std::nullopt;
    }
    TrackSample sample{.geo = {.lonDeg = *lon, .latDeg = *lat}};
    if (const auto time = report.find("time"); time != report.end()) {
        sample.timeS =
            time->is_string() ? utcSeconds(time->get<std::string>()) : finiteNumber(report, "time");
    }
    const auto speed = finiteNumber(report, "speed");
    sample.speedMps = speed && *speed >= 0.0 ? speed : std::nullopt;
    if (const auto course = finiteNumber(report, "track")) {
        sample.headingRad = headingFromBearing(*course);
    }
    return sample;
}

}  // namespace

bool looksLikeGpsd(std::string_view start) {
    Lines lines{start};
    std::string_view line;
    while (lines.next(line)) {
        line = trimmed(line);
        if (!line.empty() && !line.starts_with('#')) {
            return line.starts_with('{') && line.find("\"class\"") != std::string_view::npos;
        }
    }
    return false;
}

Result<TrackFile> gpsdTracks(std::string_view text, const std::string& where, const JobContext& job) {
    TrackFile file{.format = "gpsd log", .tracks = {}, .notes = {}};
    RecordedTrack track{.source = "gpsd log", .places = TrackPlaces::Wgs84, .samples = {}};
    std::size_t reports = 0;
    std::size_t damaged = 0;
    std::size_t withoutFix = 0;
    Lines lines{text};
    std::string_view line;
    while (lines.next(line)) {
        if (lines.number() % 4096 == 0 && job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        line = trimmed(line);
        if (!line.starts_with('{')) {
            continue;
        }
        const Json report = jsonOrDiscarded<Json>(line);
        if (!report.is_object()) {
            ++damaged;
            continue;
        }
        const auto kind = report.find("class");
        if (kind == report.end() || *kind != "TPV") {
            continue;
        }
        ++reports;
        if (const auto sample = sampleOf(report)) {
            track.samples.push_back(*sample);
        } else {
            ++withoutFix;
        }
        if (track.samples.size() > kMostTrackSamples) {
            return std::unexpected(tooManySamples(where));
        }
    }
    if (track.samples.empty()) {
        return std::unexpected(
            trackRefused(where, message("none of its {} position reports has a position", reports),
                         "record the log again with a receiver that has a fix"));
    }
    if (damaged > reports) {
        return std::unexpected(trackDamaged(where, "most of its lines are not JSON"));
    }
    file.tracks.push_back(std::move(track));
    noteSkipped(file, damaged,
                counted("{} damaged line was passed over", "{} damaged lines were passed over", damaged),
                where);
    noteSkipped(file, withoutFix,
                counted("{} report without a position was passed over",
                        "{} reports without a position were passed over", withoutFix),
                where);
    return file;
}

}  // namespace furrow
