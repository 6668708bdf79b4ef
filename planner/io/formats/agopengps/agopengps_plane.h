#pragma once

#include "planner/core/geo_point.h"
#include "planner/geometry/point.h"

namespace furrow {

/// The plane in metres in which AgOpenGPS 6 keeps a field: degrees times the length of a degree, that of
/// latitude at the origin and that of longitude at each point's own latitude (read from the program's
/// behaviour, version 6.8.4). It is sheared a little, so headings have to be taken from points in it.
class AgOpenGpsPlane {
public:
    explicit AgOpenGpsPlane(GeoPoint origin);

    GeoPoint origin() const { return origin_; }
    Point toLocal(GeoPoint point) const;
    GeoPoint toGeo(Point point) const;

private:
    GeoPoint origin_;
    double mPerDegLat_;
};

}  // namespace furrow
