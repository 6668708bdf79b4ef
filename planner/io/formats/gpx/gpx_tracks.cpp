#include "planner/io/content/geo_ring.h"
#include "planner/io/formats/gpx/gpx.h"

#include "planner/core/text.h"
#include "planner/io/tracks/track_parts.h"

#include <pugixml.hpp>

#include <cmath>
#include <format>
#include <limits>

namespace furrow {

namespace {

// In memory a document takes several times its size.
constexpr std::size_t kLargestGpxBytes = std::size_t{256} << 20U;

/// The name of an element without its prefix: extensions write <gpxtpx:speed>.
std::string_view localName(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

/// Speed and course stand in the point in GPX 1.0, in its extensions in 1.1.
void readExtras(const pugi::xml_node& node, TrackSample& sample, int depth) {
    for (const pugi::xml_node& child : node.children()) {
        const std::string_view name = localName(child);
        const std::string_view text = child.text().as_string();
        if (name == "time") {
            sample.timeS = utcSeconds(text);
        } else if (name == "speed") {
            const auto speed = numberIn(text);
            sample.speedMps = speed && std::isfinite(*speed) && *speed >= 0.0 ? speed : std::nullopt;
        } else if (name == "course") {
            const auto course = numberIn(text);
            sample.headingRad =
                course && std::isfinite(*course) ? std::optional{headingFromBearing(*course)} : std::nullopt;
        } else if ((name == "extensions" || depth > 0) && depth < 3) {
            readExtras(child, sample, depth + 1);
        }
    }
}

class GpxReader {
public:
    GpxReader(const std::string& where, const JobContext& job) : where_{where}, job_{job} {}

    /// The points of a segment or route become one track; none where it has no points.
    Result<void> read(const pugi::xml_node& parent, const char* pointName, const std::string& name) {
        RecordedTrack track{.source = name, .places = TrackPlaces::Wgs84, .samples = {}};
        for (const pugi::xml_node& point : parent.children(pointName)) {
            const double nan = std::numeric_limits<double>::quiet_NaN();
            const double lon = numberIn(point.attribute("lon").as_string()).value_or(nan);
            const double lat = numberIn(point.attribute("lat").as_string()).value_or(nan);
            if (!isOnEarth({lon, lat})) {
                return std::unexpected(trackRefused(
                    message("{}, {}, point {}", where_, name, track.samples.size() + 1),
                    message("lon=\"{}\" lat=\"{}\" is no place on Earth", point.attribute("lon").as_string(),
                            point.attribute("lat").as_string()),
                    "correct or remove the point"));
            }
            if (++count_ > kMostTrackSamples) {
                return std::unexpected(tooManySamples(where_));
            }
            if (count_ % 4096 == 0 && job_.stopRequested()) {
                return std::unexpected(cancelled());
            }
            TrackSample sample{.geo = {.lonDeg = lon, .latDeg = lat}};
            readExtras(point, sample, 0);
            track.samples.push_back(sample);
        }
        if (!track.samples.empty()) {
            file.tracks.push_back(std::move(track));
        }
        return {};
    }

    TrackFile file{.format = "GPX", .tracks = {}, .notes = {}};

private:
    const std::string& where_;
    const JobContext& job_;
    std::size_t count_ = 0;
};

std::string nameOf(const pugi::xml_node& node, std::string_view kind, int number) {
    const std::string_view name = trimmed(node.child("name").text().as_string());
    return name.empty() ? std::format("{} {}", kind, number) : std::string{name};
}

}  // namespace

Result<TrackFile> gpxTracks(std::string_view text, const std::string& where, const JobContext& job) {
    if (text.size() > kLargestGpxBytes) {
        return std::unexpected(trackRefused(where, "the GPX file is larger than 256 MiB",
                                            "cut it into the days or fields that it holds"));
    }
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed) {
        return std::unexpected(trackDamaged(message("{}, byte {}", where, parsed.offset),
                                            message("the GPX file is damaged ({})", parsed.description())));
    }
    GpxReader reader{where, job};
    const pugi::xml_node gpx = document.child("gpx");
    int number = 0;
    for (const pugi::xml_node& track : gpx.children("trk")) {
        const std::string name = nameOf(track, "track", ++number);
        int segmentNumber = 0;
        for (const pugi::xml_node& segment : track.children("trkseg")) {
            if (auto read =
                    reader.read(segment, "trkpt", std::format("{}, segment {}", name, ++segmentNumber));
                !read) {
                return std::unexpected(read.error());
            }
        }
    }
    number = 0;
    if (reader.file.tracks.empty()) {
        for (const pugi::xml_node& route : gpx.children("rte")) {
            if (auto read = reader.read(route, "rtept", nameOf(route, "route", ++number)); !read) {
                return std::unexpected(read.error());
            }
        }
    }
    if (reader.file.tracks.empty()) {
        return std::unexpected(trackRefused(where, "there is no track in this GPX file",
                                            "export the recorded track, not only its waypoints"));
    }
    return std::move(reader.file);
}

Recognition recogniseGpxTracks(const ChosenFile& chosen) {
    return chosen.xmlRoot() == "gpx" ? Recognition::Likely : Recognition::No;
}

Result<TrackFile> readGpxTracks(const ChosenFile& chosen, const JobContext& job) {
    const auto text = fileBytes(chosen.path());
    return text ? gpxTracks(*text, chosen.path().string(), job) : std::unexpected(text.error());
}

}  // namespace furrow
