#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"
#include "planner/geometry/polygon.h"

#include <span>
#include <string>
#include <string_view>

namespace furrow {

/// A plane in metres around a field: transverse Mercator on the WGS84 ellipsoid, scale 1 at its centre,
/// through PROJ. Distances differ from the geodesic by less than 1.3 mm per km within 10 km of the centre.
/// A value; may be used from several threads at once.
class LocalFrame {
public:
    /// InputRefused: the centre is not finite or outside WGS84.
    static Result<LocalFrame> centredOn(GeoPoint centre);

    /// The frame of such a string as projString() gives. InputRefused: another projection, no centre.
    static Result<LocalFrame> fromProjString(std::string_view proj);

    GeoPoint centre() const { return centre_; }
    /// The PROJ string that any other program can rebuild the frame from.
    std::string projString() const;

    Point toLocal(GeoPoint point) const;
    GeoPoint toGeo(Point point) const;

    Ring toLocal(std::span<const GeoPoint> points) const;
    GeoRing toGeo(std::span<const Point> points) const;
    Polygon toLocal(const GeoPolygon& polygon) const;
    GeoPolygon toGeo(const Polygon& polygon) const;

    friend bool operator==(const LocalFrame&, const LocalFrame&) = default;

private:
    explicit LocalFrame(GeoPoint centre) : centre_{centre} {}
    GeoPoint centre_;
};

/// The middle of the bounding box of these points, right across the antimeridian too.
GeoPoint middleOf(std::span<const GeoPolygon> polygons);

/// Area on the ellipsoid, holes taken out (Karney 2013, doi 10.1007/s00190-012-0578-z, through PROJ).
Area geodesicArea(const GeoPolygon& polygon);

}  // namespace furrow
