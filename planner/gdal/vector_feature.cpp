#include "planner/gdal/vector_feature.h"

#include "planner/core/file_error.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace furrow {

namespace {

/// The first finite point that cannot be a longitude and latitude.
std::optional<GeoPoint> firstOutOfRange(const VectorFeature& feature) {
    const auto outside = [](const GeoPoint& point) {
        return std::isfinite(point.lonDeg) && std::isfinite(point.latDeg) &&
               (std::abs(point.lonDeg) > 180.0 || std::abs(point.latDeg) > 90.0);
    };
    const auto firstOf = [&outside](const GeoRing& ring) -> std::optional<GeoPoint> {
        const auto found = std::ranges::find_if(ring, outside);
        return found == ring.end() ? std::nullopt : std::optional{*found};
    };
    for (const GeoPolygon& polygon : feature.polygons) {
        if (const auto found = firstOf(polygon.outer)) {
            return found;
        }
    }
    for (const GeoRing& ring : feature.closedLines) {
        if (const auto found = firstOf(ring)) {
            return found;
        }
    }
    return firstOf(feature.points);
}

}  // namespace

Result<void> checkDegrees(const VectorFeature& feature, const std::string& where) {
    if (const auto point = firstOutOfRange(feature)) {
        return std::unexpected(
            inputRefused(where,
                         message("{:.3f}, {:.3f} is no longitude and latitude, and the file does not say "
                                 "which coordinate system it uses",
                                 point->lonDeg, point->latDeg),
                         "add the .prj file that belongs to it, or export the field again in WGS84"));
    }
    return {};
}

}  // namespace furrow
