#include "planner/gdal/to_wgs84.h"

#include "planner/core/file_error.h"

#include <cpl_error.h>

#include <limits>
#include <string_view>

namespace furrow {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

bool isKnown(const OGRSpatialReference* source) {
    if (source == nullptr || source->IsEmpty() || source->IsLocal()) {
        return false;
    }
    const char* name = source->GetName();
    // GeoPackage's own way to say that the system is not known.
    return name == nullptr || !std::string_view{name}.starts_with("Undefined");
}

}  // namespace

OGRSpatialReference wgs84System() {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return wgs84;
}

Result<ToWgs84> ToWgs84::from(const OGRSpatialReference* source, const std::string& where) {
    ToWgs84 made;
    made.known_ = isKnown(source);
    if (!made.known_) {
        return made;
    }
    const OGRSpatialReference wgs84 = wgs84System();
    if (source->IsSame(&wgs84) != 0) {
        return made;  // the numbers of the file to the last bit
    }
    made.transform_.reset(OGRCreateCoordinateTransformation(source, &wgs84));
    if (!made.transform_) {
        const char* name = source->GetName();
        return std::unexpected(inputRefused(
            where,
            message("its coordinate system '{}' cannot be turned into WGS84", name == nullptr ? "" : name),
            "export the field again in WGS84 (longitude and latitude)"));
    }
    return made;
}

GeoRing ToWgs84::points(const OGRSimpleCurve& line) const {
    const auto count = static_cast<std::size_t>(line.getNumPoints());
    std::vector<double> x(count);
    std::vector<double> y(count);
    for (std::size_t i = 0; i < count; ++i) {
        x[i] = line.getX(static_cast<int>(i));
        y[i] = line.getY(static_cast<int>(i));
    }
    return converted(x, y);
}

GeoPoint ToWgs84::point(const OGRPoint& point) const {
    std::vector<double> x{point.getX()};
    std::vector<double> y{point.getY()};
    return converted(x, y).front();
}

GeoRing ToWgs84::converted(std::vector<double>& x, std::vector<double>& y) const {
    if (transform_ && !x.empty()) {
        std::vector<int> good(x.size(), 1);
        // What cannot be converted is told by the place of the point, not by a message.
        CPLPushErrorHandler(CPLQuietErrorHandler);
        transform_->Transform(x.size(), x.data(), y.data(), nullptr, good.data());
        CPLPopErrorHandler();
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (good[i] == 0) {
                x[i] = kNaN;
                y[i] = kNaN;
            }
        }
    }
    GeoRing ring;
    ring.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        ring.push_back({x[i], y[i]});
    }
    return ring;
}

}  // namespace furrow
