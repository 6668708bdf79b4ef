#include "planner/io/content/geo_ring.h"
#include "planner/io/formats/logs/logs.h"

#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/io/tracks/track_parts.h"

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace furrow {

namespace {

constexpr double kKnotMps = 1852.0 / 3600.0;
constexpr double kDayS = 86'400.0;

using Fields = std::vector<std::string_view>;

/// What stands between '$' and '*', where its checksum is right; sentences without one are taken.
std::optional<std::string_view> sentenceIn(std::string_view line, bool& damaged) {
    // The last one: the logger's own bytes before it may hold others.
    const std::size_t begin = line.rfind('$');
    if (begin == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view sentence = trimmed(line.substr(begin + 1));
    const std::size_t star = sentence.rfind('*');
    if (star == std::string_view::npos) {
        return sentence;
    }
    unsigned sum = 0;
    for (const char letter : sentence.substr(0, star)) {
        sum ^= static_cast<unsigned char>(letter);
    }
    unsigned stated = 256;
    const std::string_view digits = sentence.substr(star + 1);
    std::from_chars(digits.data(), digits.data() + digits.size(), stated, 16);
    damaged = stated != sum;
    return damaged ? std::nullopt : std::optional{sentence.substr(0, star)};
}

/// "4134.4979" with two (latitude) or three digits of degrees before the minutes.
std::optional<double> angleDeg(std::string_view value, std::string_view hemisphere, char positive,
                               char negative) {
    const auto number = numberIn(value);
    if (!number || !(*number >= 0.0 && *number < 18'060.0) || hemisphere.size() != 1 ||
        (hemisphere[0] != positive && hemisphere[0] != negative)) {
        return std::nullopt;
    }
    const double whole = std::floor(*number / 100.0);
    const double angle = whole + (*number - 100.0 * whole) / 60.0;
    return hemisphere[0] == positive ? angle : -angle;
}

std::optional<GeoPoint> placeFrom(const Fields& fields, std::size_t at) {
    const auto lat = angleDeg(fields[at], fields[at + 1], 'N', 'S');
    const auto lon = angleDeg(fields[at + 2], fields[at + 3], 'E', 'W');
    if (!lat || !lon || !isOnEarth({*lon, *lat})) {
        return std::nullopt;
    }
    return GeoPoint{.lonDeg = *lon, .latDeg = *lat};
}

/// "132819.60"
std::optional<double> secondsOfDay(std::string_view text) {
    const auto number = numberIn(text);
    if (!number || !(*number >= 0.0 && *number < 240'000.0)) {
        return std::nullopt;
    }
    const double hours = std::floor(*number / 10'000.0);
    const double minutes = std::floor((*number - 10'000.0 * hours) / 100.0);
    return 3600.0 * hours + 60.0 * minutes + (*number - 10'000.0 * hours - 100.0 * minutes);
}

/// "180320" is 2020-03-18.
std::optional<double> midnightOf(std::string_view text) {
    const auto number = numberIn(text);
    if (text.size() != 6 || !number || *number < 0.0) {
        return std::nullopt;
    }
    const auto date = static_cast<unsigned>(*number);
    const unsigned year = date % 100;
    // GPS began in 1980.
    return utcMidnight(static_cast<int>(year < 80 ? 2000 + year : 1900 + year), date / 100 % 100,
                       date / 10'000);
}

/// RMC: time, status, latitude, longitude, speed in knots, course, date.
std::optional<TrackSample> fromRmc(const Fields& fields) {
    if (fields.size() < 10 || fields[2] != "A") {
        return std::nullopt;
    }
    const auto place = placeFrom(fields, 3);
    if (!place) {
        return std::nullopt;
    }
    TrackSample sample{.geo = *place};
    const auto time = secondsOfDay(fields[1]);
    const auto midnight = midnightOf(fields[9]);
    if (time && midnight) {
        sample.timeS = *midnight + *time;
    }
    const auto knots = numberIn(fields[7]);
    if (knots && std::isfinite(*knots) && *knots >= 0.0) {
        sample.speedMps = *knots * kKnotMps;
    }
    const auto course = numberIn(fields[8]);
    if (course && std::isfinite(*course)) {
        sample.headingRad = headingFromBearing(*course);
    }
    return sample;
}

/// GGA: time, latitude, longitude, quality. It has no date: days are counted from the first midnight.
std::optional<TrackSample> fromGga(const Fields& fields) {
    if (fields.size() < 7 || fields[6].empty() || fields[6] == "0") {
        return std::nullopt;
    }
    const auto place = placeFrom(fields, 2);
    if (!place) {
        return std::nullopt;
    }
    return TrackSample{.geo = *place, .timeS = secondsOfDay(fields[1])};
}

void countDays(std::vector<TrackSample>& samples) {
    double midnight = 0.0;
    double before = 0.0;
    for (TrackSample& sample : samples) {
        if (sample.timeS) {
            if (*sample.timeS < before - 0.5 * kDayS) {
                midnight += kDayS;
            }
            before = *sample.timeS;
            *sample.timeS += midnight;
        }
    }
}

}  // namespace

bool holdsNmea(std::string_view start) {
    Lines lines{start};
    std::string_view line;
    while (lines.next(line)) {
        bool damaged = false;
        const auto sentence = line.contains('*') ? sentenceIn(line, damaged) : std::nullopt;
        if (sentence &&
            (sentence->substr(0, 6).ends_with("RMC,") || sentence->substr(0, 6).ends_with("GGA,"))) {
            return true;
        }
    }
    return false;
}

bool looksLikeNmea(std::string_view start) {
    Lines lines{start};
    std::string_view line;
    while (lines.next(line)) {
        const std::size_t at = line.rfind('$');
        // "$GPRMC,", "$GNGGA,", but also a time stamp of the logger before it.
        if (at != std::string_view::npos && line.size() > at + 6 && line[at + 6] == ',') {
            return true;
        }
    }
    return false;
}

Result<TrackFile> nmeaTracks(std::string_view text, const std::string& where, const JobContext& job) {
    std::vector<TrackSample> rmc;
    std::vector<TrackSample> gga;
    std::size_t sentences = 0;
    std::size_t damagedCount = 0;
    std::size_t withoutFix = 0;
    Lines lines{text};
    std::string_view line;
    while (lines.next(line)) {
        if (lines.number() % 4096 == 0 && job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        bool damaged = false;
        const auto sentence = sentenceIn(line, damaged);
        damagedCount += damaged ? 1 : 0;
        if (!sentence || sentence->size() < 6) {
            continue;
        }
        // Whatever system the receiver speaks for (GP, GL, GN ...) stands before the three letters.
        const std::string_view kind = sentence->substr(2, 4);
        const bool isRmc = kind == "RMC,";
        if (!isRmc && kind != "GGA,") {
            continue;
        }
        ++sentences;
        const auto sample = isRmc ? fromRmc(cellsOf(*sentence, ',')) : fromGga(cellsOf(*sentence, ','));
        if (sample) {
            (isRmc ? rmc : gga).push_back(*sample);
        } else {
            ++withoutFix;
        }
        if (rmc.size() + gga.size() > 2 * kMostTrackSamples) {
            return std::unexpected(tooManySamples(where));
        }
    }
    countDays(gga);
    RecordedTrack track{.source = "NMEA log",
                        .places = TrackPlaces::Wgs84,
                        .samples = rmc.empty() ? std::move(gga) : std::move(rmc)};
    if (track.samples.empty()) {
        return std::unexpected(
            damagedCount > 0
                ? trackDamaged(where, message("{} of its sentences have a wrong checksum", damagedCount))
                : trackRefused(where,
                               message("none of its {} RMC and GGA sentences has a position", sentences),
                               "record the log again with a receiver that has a fix"));
    }
    if (damagedCount > sentences) {
        return std::unexpected(trackDamaged(where, "most of its sentences have a wrong checksum"));
    }
    TrackFile file{.format = "NMEA log", .tracks = {}, .notes = {}};
    file.tracks.push_back(std::move(track));
    noteSkipped(file, damagedCount,
                counted("{} sentence with a wrong checksum was passed over",
                        "{} sentences with a wrong checksum were passed over", damagedCount),
                where);
    noteSkipped(file, withoutFix,
                counted("{} sentence without a position was passed over",
                        "{} sentences without a position were passed over", withoutFix),
                where);
    return file;
}

}  // namespace furrow
