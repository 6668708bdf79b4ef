#include "planner/geometry/wkt.h"

#include "planner/geometry/geos_shapes.h"

#include <utility>

namespace furrow {

using namespace geos;

namespace {

Error notALine(const std::string& wkt) {
    return {.code = ErrorCode::InputRefused,
            .what = message("'{}' is not a line", wkt),
            .where = {},
            .remedy = "write it like LINESTRING (4.1 52.0, 4.2 52.0)"};
}

/// Empty if the text is no WKT, or an empty geometry.
Geometry fromWkt(const std::string& wkt) {
    GEOSWKTReader* const reader = GEOSWKTReader_create_r(handle());
    Geometry geometry{GEOSWKTReader_read_r(handle(), reader, wkt.c_str())};
    GEOSWKTReader_destroy_r(handle(), reader);
    return geometry && GEOSisEmpty_r(handle(), geometry.get()) == 1 ? Geometry{} : std::move(geometry);
}

}  // namespace

Result<std::vector<Point>> pointsOfWkt(const std::string& wkt) {
    const Geometry geometry = fromWkt(wkt);
    const int type = geometry ? GEOSGeomTypeId_r(handle(), geometry.get()) : -1;
    if (type != GEOS_LINESTRING && type != GEOS_POINT) {
        return std::unexpected(notALine(wkt));
    }
    return pointsOf(geometry.get());
}

Result<std::vector<Point>> placesOfWkt(const std::string& wkt) {
    const Geometry geometry = fromWkt(wkt);
    const int count = geometry ? GEOSGetNumGeometries_r(handle(), geometry.get()) : 0;
    std::vector<Point> places;
    for (int i = 0; i < count; ++i) {
        const GEOSGeometry* const part = GEOSGetGeometryN_r(handle(), geometry.get(), i);
        if (GEOSGeomTypeId_r(handle(), part) != GEOS_POINT || GEOSisEmpty_r(handle(), part) == 1) {
            return std::unexpected(notALine(wkt));
        }
        places.push_back(pointsOf(part).front());
    }
    if (places.empty()) {
        return std::unexpected(notALine(wkt));
    }
    return places;
}

Result<std::vector<Polyline>> linesOfWkt(const std::string& wkt) {
    const Geometry geometry = fromWkt(wkt);
    const int count = geometry ? GEOSGetNumGeometries_r(handle(), geometry.get()) : 0;
    std::vector<Polyline> lines;
    for (int i = 0; i < count; ++i) {
        const GEOSGeometry* const part = GEOSGetGeometryN_r(handle(), geometry.get(), i);
        const int type = GEOSGeomTypeId_r(handle(), part);
        if (type == GEOS_LINESTRING) {
            lines.push_back(pointsOf(part));
            continue;
        }
        if (type != GEOS_MULTILINESTRING) {
            return std::unexpected(notALine(wkt));
        }
        for (int k = 0; k < GEOSGetNumGeometries_r(handle(), part); ++k) {
            lines.push_back(pointsOf(GEOSGetGeometryN_r(handle(), part, k)));
        }
    }
    if (lines.empty()) {
        return std::unexpected(notALine(wkt));
    }
    return lines;
}

}  // namespace furrow
