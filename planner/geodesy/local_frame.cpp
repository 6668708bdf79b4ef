#include "planner/geodesy/local_frame.h"

#include <geodesic.h>
#include <proj.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <format>
#include <memory>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr double kWgs84SemiMajorM = 6378137.0;
constexpr double kWgs84Flattening = 1.0 / 298.257223563;

struct ContextDeleter {
    void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct TransformDeleter {
    void operator()(PJ* transform) const { proj_destroy(transform); }
};

// PROJ objects must not be used by two threads at a time, and making one costs far more than using it,
// so each thread keeps the one it used last.
struct ThreadTransform {
    ThreadTransform() { proj_context_set_enable_network(context.get(), 0); }

    std::unique_ptr<PJ_CONTEXT, ContextDeleter> context{proj_context_create()};
    std::unique_ptr<PJ, TransformDeleter> transform;
    GeoPoint centre;
};

PJ* transformAt(GeoPoint centre, const std::string& definition) {
    thread_local ThreadTransform cached;
    if (!cached.transform || cached.centre != centre) {
        cached.transform.reset(proj_create(cached.context.get(), definition.c_str()));
        cached.centre = centre;
    }
    return cached.transform.get();
}

double toRadians(double degrees) {
    return proj_torad(degrees);
}

}  // namespace

Result<LocalFrame> LocalFrame::centredOn(GeoPoint centre) {
    if (!(std::abs(centre.lonDeg) <= 180.0) || !(std::abs(centre.latDeg) <= 90.0)) {
        return std::unexpected(
            Error{.code = ErrorCode::InputRefused,
                  .what = "the coordinates lie outside longitude -180 to 180 and latitude -90 to 90",
                  .remedy = "check the file's coordinate system"});
    }
    return LocalFrame{centre};
}

Result<LocalFrame> LocalFrame::fromProjString(std::string_view proj) {
    const auto number = [proj](std::string_view key) -> std::optional<double> {
        const std::size_t at = proj.find(key);
        double value = 0.0;
        if (at == std::string_view::npos) {
            return std::nullopt;
        }
        const char* const begin = proj.data() + at + key.size();
        return std::from_chars(begin, proj.data() + proj.size(), value).ec == std::errc{}
                   ? std::optional{value}
                   : std::nullopt;
    };
    const auto latitude = number("+lat_0=");
    const auto longitude = number("+lon_0=");
    if (!proj.contains("+proj=tmerc") || !latitude || !longitude) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = message("'{}' is no local frame", proj),
                                     .where = {},
                                     .remedy = "give a transverse Mercator with +lat_0 and +lon_0"});
    }
    return centredOn({.lonDeg = *longitude, .latDeg = *latitude});
}

std::string LocalFrame::projString() const {
    return std::format("+proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +ellps=WGS84 +units=m +no_defs",
                       centre_.latDeg, centre_.lonDeg);
}

Ring LocalFrame::toLocal(std::span<const GeoPoint> points) const {
    PJ* transform = transformAt(centre_, projString());
    Ring local;
    local.reserve(points.size());
    for (const GeoPoint& point : points) {
        const PJ_COORD out = proj_trans(
            transform, PJ_FWD, proj_coord(toRadians(point.lonDeg), toRadians(point.latDeg), 0.0, 0.0));
        local.push_back({out.xy.x, out.xy.y});
    }
    return local;
}

GeoRing LocalFrame::toGeo(std::span<const Point> points) const {
    PJ* transform = transformAt(centre_, projString());
    GeoRing geo;
    geo.reserve(points.size());
    for (const Point& point : points) {
        const PJ_COORD out = proj_trans(transform, PJ_INV, proj_coord(point.x, point.y, 0.0, 0.0));
        geo.push_back({proj_todeg(out.lp.lam), proj_todeg(out.lp.phi)});
    }
    return geo;
}

Point LocalFrame::toLocal(GeoPoint point) const {
    return toLocal(std::span<const GeoPoint>{&point, 1}).front();
}

GeoPoint LocalFrame::toGeo(Point point) const {
    return toGeo(std::span<const Point>{&point, 1}).front();
}

Polygon LocalFrame::toLocal(const GeoPolygon& polygon) const {
    Polygon local{.outer = toLocal(polygon.outer), .holes = {}};
    for (const GeoRing& hole : polygon.holes) {
        local.holes.push_back(toLocal(hole));
    }
    return local;
}

GeoPolygon LocalFrame::toGeo(const Polygon& polygon) const {
    GeoPolygon geo{.outer = toGeo(polygon.outer), .holes = {}};
    for (const Ring& hole : polygon.holes) {
        geo.holes.push_back(toGeo(hole));
    }
    return geo;
}

GeoPoint middleOf(std::span<const GeoPolygon> polygons) {
    bool first = true;
    double anchor = 0.0;
    GeoPoint low;
    GeoPoint high;
    for (const GeoPolygon& polygon : polygons) {
        for (const GeoPoint& point : polygon.outer) {
            if (first) {
                anchor = point.lonDeg;
            }
            // Within half a turn of the first point, so that a field across the antimeridian is one piece.
            const double lon = anchor + std::remainder(point.lonDeg - anchor, 360.0);
            low = first ? GeoPoint{lon, point.latDeg}
                        : GeoPoint{std::min(low.lonDeg, lon), std::min(low.latDeg, point.latDeg)};
            high = first ? GeoPoint{lon, point.latDeg}
                         : GeoPoint{std::max(high.lonDeg, lon), std::max(high.latDeg, point.latDeg)};
            first = false;
        }
    }
    return {std::remainder(0.5 * (low.lonDeg + high.lonDeg), 360.0), 0.5 * (low.latDeg + high.latDeg)};
}

Area geodesicArea(const GeoPolygon& polygon) {
    geod_geodesic ellipsoid;
    geod_init(&ellipsoid, kWgs84SemiMajorM, kWgs84Flattening);
    const auto ringArea = [&ellipsoid](const GeoRing& ring) {
        geod_polygon sum;
        geod_polygon_init(&sum, 0);
        for (const GeoPoint& point : ring) {
            geod_polygon_addpoint(&ellipsoid, &sum, point.latDeg, point.lonDeg);
        }
        double areaM2 = 0.0;
        geod_polygon_compute(&ellipsoid, &sum, 0, 1, &areaM2, nullptr);
        return std::abs(areaM2);
    };
    double areaM2 = ringArea(polygon.outer);
    for (const GeoRing& hole : polygon.holes) {
        areaM2 -= ringArea(hole);
    }
    return squareMetres(areaM2);
}

}  // namespace furrow
