#include "planner/io/geo_ring.h"

#include <cmath>
#include <numbers>

namespace furrow {

bool isCounterClockwise(std::span<const GeoPoint> ring) {
    double twiceArea = 0.0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const double fromLon = std::remainder(ring[j].lonDeg - ring[0].lonDeg, 360.0);
        const double toLon = std::remainder(ring[i].lonDeg - ring[0].lonDeg, 360.0);
        twiceArea += fromLon * (ring[i].latDeg - ring[0].latDeg) - toLon * (ring[j].latDeg - ring[0].latDeg);
    }
    return twiceArea > 0.0;
}

double lonNear(double lonDeg, double anchorDeg) {
    return anchorDeg + std::remainder(lonDeg - anchorDeg, 360.0);
}

bool contains(std::span<const GeoPoint> ring, GeoPoint point) {
    bool inside = false;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
        const GeoPoint a{lonNear(ring[i].lonDeg, point.lonDeg), ring[i].latDeg};
        const GeoPoint b{lonNear(ring[j].lonDeg, point.lonDeg), ring[j].latDeg};
        if ((a.latDeg > point.latDeg) != (b.latDeg > point.latDeg) &&
            point.lonDeg <
                a.lonDeg + (b.lonDeg - a.lonDeg) * (point.latDeg - a.latDeg) / (b.latDeg - a.latDeg)) {
            inside = !inside;
        }
    }
    return inside;
}

double roughDistanceM(GeoPoint a, GeoPoint b) {
    constexpr double kMetresPerDegree = 111'195.0;  // of a sphere of the earth's mean radius
    const double east = std::remainder(b.lonDeg - a.lonDeg, 360.0) * std::cos(a.latDeg * std::numbers::pi / 180.0);
    return kMetresPerDegree * std::hypot(east, b.latDeg - a.latDeg);
}

}  // namespace furrow
