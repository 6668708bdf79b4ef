#include "planner/io/content/geo_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

namespace {

bool edgesMeet(GeoPoint p, GeoPoint q, GeoPoint r, GeoPoint s) {
    const auto apart = [&](double GeoPoint::* axis) {
        return std::max(p.*axis, q.*axis) < std::min(r.*axis, s.*axis) ||
               std::min(p.*axis, q.*axis) > std::max(r.*axis, s.*axis);
    };
    const auto side = [](GeoPoint from, GeoPoint to, GeoPoint point) {
        return (to.lonDeg - from.lonDeg) * (point.latDeg - from.latDeg) -
               (to.latDeg - from.latDeg) * (point.lonDeg - from.lonDeg);
    };
    return !apart(&GeoPoint::latDeg) && !apart(&GeoPoint::lonDeg) && side(p, q, r) * side(p, q, s) <= 0.0 &&
           side(r, s, p) * side(r, s, q) <= 0.0;
}

}  // namespace

bool isOnEarth(GeoPoint point) {
    return std::abs(point.lonDeg) <= 180.0 && std::abs(point.latDeg) <= 90.0;  // false for NaN
}

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

bool meet(std::span<const GeoPoint> a, std::span<const GeoPoint> b) {
    if (a.empty() || b.empty()) {
        return false;
    }
    if (contains(a, b.front()) || contains(b, a.front())) {
        return true;
    }
    // Neither lies in the other: then edges cross, or nothing is shared.
    const auto unrolled = [anchor = a.front().lonDeg](std::span<const GeoPoint> ring) {
        GeoRing points{ring.begin(), ring.end()};
        for (GeoPoint& point : points) {
            point.lonDeg = lonNear(point.lonDeg, anchor);
        }
        return points;
    };
    const GeoRing one = unrolled(a);
    const GeoRing other = unrolled(b);
    const auto [south, north] = std::ranges::minmax(other, {}, &GeoPoint::latDeg);
    for (std::size_t i = 0, j = one.size() - 1; i < one.size(); j = i++) {
        if (std::max(one[i].latDeg, one[j].latDeg) < south.latDeg ||
            std::min(one[i].latDeg, one[j].latDeg) > north.latDeg) {
            continue;
        }
        for (std::size_t k = 0, l = other.size() - 1; k < other.size(); l = k++) {
            if (edgesMeet(one[i], one[j], other[k], other[l])) {
                return true;
            }
        }
    }
    return false;
}

double roughDistanceM(GeoPoint a, GeoPoint b) {
    constexpr double kMetresPerDegree = 111'195.0;  // of a sphere of the earth's mean radius
    const double east =
        std::remainder(b.lonDeg - a.lonDeg, 360.0) * std::cos(a.latDeg * std::numbers::pi / 180.0);
    return kMetresPerDegree * std::hypot(east, b.latDeg - a.latDeg);
}

}  // namespace furrow
