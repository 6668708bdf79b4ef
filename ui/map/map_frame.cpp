#include "ui/map/map_frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

namespace {
constexpr double kPi = std::numbers::pi;
/// Where the Mercator square ends.
constexpr double kMaxLatitudeDeg = 85.05112877980659;
constexpr double kEquatorM = 40075016.685578488;
}  // namespace

WorldPoint worldPoint(GeoPoint place) {
    const double latRad = std::clamp(place.latDeg, -kMaxLatitudeDeg, kMaxLatitudeDeg) * kPi / 180.0;
    return {(place.lonDeg + 180.0) / 360.0, 0.5 - std::asinh(std::tan(latRad)) / (2.0 * kPi)};
}

WorldPoint worldPoint(const QGeoCoordinate& place) {
    return worldPoint(geoPoint(place));
}

GeoPoint geoPoint(WorldPoint place) {
    const double turns = place.x - std::floor(place.x);
    return {.lonDeg = turns * 360.0 - 180.0,
            .latDeg = std::atan(std::sinh((0.5 - place.y) * 2.0 * kPi)) * 180.0 / kPi};
}

GeoPoint geoPoint(const QGeoCoordinate& place) {
    return {.lonDeg = place.longitude(), .latDeg = place.latitude()};
}

QGeoCoordinate coordinate(WorldPoint place) {
    return coordinate(geoPoint(place));
}

QGeoCoordinate coordinate(GeoPoint place) {
    return QGeoCoordinate{place.latDeg, place.lonDeg};
}

MapPoint mapPoint(WorldPoint place, WorldPoint origin) {
    WorldPoint way = place - origin;
    // The short way around the world: a field may lie across the antimeridian.
    way.x -= std::round(way.x);
    return {static_cast<float>(way.x * kUnitsPerWorld), static_cast<float>(way.y * kUnitsPerWorld)};
}

MapFrame::MapFrame(const LocalFrame& frame)
    : frame_{frame},
      origin_{worldPoint(frame.centre())},
      unitsPerMetre_{kUnitsPerWorld / (kEquatorM * std::cos(frame.centre().latDeg * kPi / 180.0))} {}

MapPoint MapFrame::map(Point point) const {
    return mapPoint(worldPoint(frame_.toGeo(point)), origin_);
}

std::vector<MapPoint> MapFrame::map(std::span<const Point> points) const {
    std::vector<MapPoint> result;
    result.reserve(points.size());
    for (const GeoPoint& place : frame_.toGeo(points)) {
        result.push_back(mapPoint(worldPoint(place), origin_));
    }
    return result;
}

}  // namespace furrow
