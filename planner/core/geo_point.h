#pragma once

#include <vector>

namespace furrow {

/// A place in WGS84: degrees, east and north positive.
struct GeoPoint {
    double lonDeg = 0.0;
    double latDeg = 0.0;

    friend bool operator==(const GeoPoint&, const GeoPoint&) = default;
};

/// A closed ring; the first point is not repeated at the end.
using GeoRing = std::vector<GeoPoint>;

struct GeoPolygon {
    GeoRing outer;
    std::vector<GeoRing> holes;

    friend bool operator==(const GeoPolygon&, const GeoPolygon&) = default;
};

}  // namespace furrow
