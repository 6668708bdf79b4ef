#include "planner/io/tracks/track_parts.h"

#include "planner/core/text.h"
#include "planner/units/angle.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <utility>

namespace furrow {

Error trackRefused(Message where, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = std::move(where),
            .remedy = std::move(remedy)};
}

Error trackDamaged(Message where, Message what) {
    return {.code = ErrorCode::ReadFailed,
            .what = std::move(what),
            .where = std::move(where),
            .remedy = "copy or export the recording again"};
}

Error tooManySamples(Message where) {
    return trackRefused(std::move(where), message("it holds more than {} positions", kMostTrackSamples),
                        "cut it into the days or fields that it holds");
}

double headingFromBearing(double bearingDeg) {
    return normalisedPoseHeading(degrees(90.0 - bearingDeg)).si();
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

void noteSkipped(TrackFile& file, std::size_t count, Message what, const Message& where) {
    if (count > 0) {
        file.notes.push_back({.text = std::move(what), .where = where});
    }
}

}  // namespace furrow
