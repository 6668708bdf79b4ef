#pragma once

#include "planner/geodesy/local_frame.h"

#include <QGeoCoordinate>

namespace furrow {

/// A place in web Mercator: the world is the unit square, x to the east, y to the south.
struct WorldPoint {
    double x = 0.5;
    double y = 0.5;

    friend bool operator==(const WorldPoint&, const WorldPoint&) = default;
    friend WorldPoint operator-(WorldPoint a, WorldPoint b) { return {a.x - b.x, a.y - b.y}; }
};

WorldPoint worldPoint(GeoPoint place);
WorldPoint worldPoint(const QGeoCoordinate& place);
GeoPoint geoPoint(WorldPoint place);
GeoPoint geoPoint(const QGeoCoordinate& place);
QGeoCoordinate coordinate(WorldPoint place);
QGeoCoordinate coordinate(GeoPoint place);

/// What the scene graph gets: single precision, in pixels of zoom 22, from an origin nearby.
struct MapPoint {
    float x = 0.0F;
    float y = 0.0F;

    friend bool operator==(MapPoint, MapPoint) = default;
};

/// Pixels of zoom 22 around the world.
inline constexpr double kUnitsPerWorld = 256.0 * 4194304.0;

MapPoint mapPoint(WorldPoint place, WorldPoint origin);

/// The one way from a field's local frame to the map. A value; may be used from several threads at once.
class MapFrame {
public:
    explicit MapFrame(const LocalFrame& frame);

    WorldPoint origin() const { return origin_; }
    double unitsPerMetre() const { return unitsPerMetre_; }
    GeoPoint geo(Point point) const { return frame_.toGeo(point); }
    MapPoint map(Point point) const;
    std::vector<MapPoint> map(std::span<const Point> points) const;

private:
    LocalFrame frame_;
    WorldPoint origin_;
    double unitsPerMetre_ = 1.0;
};

}  // namespace furrow
