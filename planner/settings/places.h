#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// One of the places of a setting: a point, or what may be the name of a gate.
struct GivenPlace {
    std::string name;
    std::optional<GeoPoint> point;

    friend bool operator==(const GivenPlace&, const GivenPlace&) = default;
};

/// The places in a text of ParameterKind::Places, in their order: pieces divided by semicolons, each a WKT
/// POINT or MULTIPOINT in WGS84, or a name. InputRefused: a point that is not on the globe.
Result<std::vector<GivenPlace>> givenPlaces(std::string_view text);

/// A text that reads back as these places: points to a millimetre, points alone as one POINT or MULTIPOINT.
std::string placesText(const std::vector<GivenPlace>& places);

}  // namespace furrow
