#include "planner/gdal/utm_zone.h"

#include "planner/gdal/drivers.h"
#include "planner/gdal/messages.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace furrow {

namespace {

constexpr int kWgs84 = 4326;

Error noPlaceIn(int epsg) {
    return {.code = ErrorCode::WriteFailed,
            .what = message("a point has no place in EPSG:{}", epsg),
            .where = "",
            .remedy = "choose another format"};
}

/// Coordinates of one system in another, in place. False where one of them has no place there.
bool transform(int fromEpsg, int toEpsg, std::vector<double>& x, std::vector<double>& y) {
    registerGdalDrivers();
    const GdalMessages messages;
    OGRSpatialReference from;
    OGRSpatialReference to;
    if (from.importFromEPSG(fromEpsg) != OGRERR_NONE || to.importFromEPSG(toEpsg) != OGRERR_NONE) {
        return false;
    }
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation, decltype(&OGRCoordinateTransformation::DestroyCT)>
        made{OGRCreateCoordinateTransformation(&from, &to), &OGRCoordinateTransformation::DestroyCT};
    return made && (x.empty() || made->Transform(x.size(), x.data(), y.data()) != 0);
}

}  // namespace

UtmZone UtmZone::of(GeoPoint place) {
    const int zone = std::clamp(static_cast<int>(std::floor((place.lonDeg + 180.0) / 6.0)) + 1, 1, 60);
    return {(place.latDeg < 0.0 ? 32700 : 32600) + zone};
}

Result<std::vector<std::pair<double, double>>> UtmZone::project(std::span<const GeoPoint> points) const {
    std::vector<double> x;
    std::vector<double> y;
    for (const GeoPoint& point : points) {
        x.push_back(point.lonDeg);
        y.push_back(point.latDeg);
    }
    if (!transform(kWgs84, epsg, x, y)) {
        return std::unexpected(noPlaceIn(epsg));
    }
    std::vector<std::pair<double, double>> projected;
    for (std::size_t i = 0; i < x.size(); ++i) {
        projected.emplace_back(x[i], y[i]);
    }
    return projected;
}

Result<GeoRing> UtmZone::unproject(std::span<const std::pair<double, double>> places) const {
    std::vector<double> x;
    std::vector<double> y;
    for (const auto& [east, north] : places) {
        x.push_back(east);
        y.push_back(north);
    }
    if (!transform(epsg, kWgs84, x, y)) {
        return std::unexpected(noPlaceIn(epsg));
    }
    GeoRing points;
    for (std::size_t i = 0; i < x.size(); ++i) {
        points.push_back({x[i], y[i]});
    }
    return points;
}

}  // namespace furrow
