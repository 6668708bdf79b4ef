#include "planner/settings/places.h"

#include "planner/geometry/wkt.h"

#include <algorithm>
#include <cmath>
#include <format>

namespace furrow {

namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\n";
    const std::size_t first = text.find_first_not_of(kBlanks);
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string pointText(const GeoPoint& point) {
    return std::format("{:.8f} {:.8f}", point.lonDeg, point.latDeg);
}

}  // namespace

Result<std::vector<GivenPlace>> givenPlaces(std::string_view text) {
    std::vector<GivenPlace> places;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        const std::string one{trimmed(text.substr(0, end))};
        text.remove_prefix(std::min(end + 1, text.size()));
        if (one.empty()) {
            continue;
        }
        const auto points = placesOfWkt(one);
        if (!points) {
            places.push_back({.name = one, .point = {}});
            continue;
        }
        for (const Point& point : *points) {
            if (!(std::abs(point.x) <= 180.0 && std::abs(point.y) <= 90.0)) {
                return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                             .what = message("{} {} is no place in WGS84", point.x, point.y),
                                             .where = {},
                                             .remedy = "give longitude, then latitude, in degrees"});
            }
            places.push_back({.name = {}, .point = GeoPoint{.lonDeg = point.x, .latDeg = point.y}});
        }
    }
    return places;
}

std::string placesText(const std::vector<GivenPlace>& places) {
    const bool arePoints =
        std::ranges::all_of(places, [](const GivenPlace& place) { return place.point.has_value(); });
    std::string text;
    for (const GivenPlace& place : places) {
        if (!text.empty()) {
            text += arePoints ? ", " : "; ";
        }
        text += !place.point                     ? place.name
                : arePoints && places.size() > 1 ? std::format("({})", pointText(*place.point))
                                                 : std::format("POINT ({})", pointText(*place.point));
    }
    return arePoints && places.size() > 1 ? std::format("MULTIPOINT ({})", text) : text;
}

}  // namespace furrow
