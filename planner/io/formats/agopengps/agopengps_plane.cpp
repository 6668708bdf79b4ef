#include "planner/io/formats/agopengps/agopengps_plane.h"

#include <cmath>
#include <numbers>

namespace furrow {

namespace {

double inRadians(double degrees) {
    return degrees * std::numbers::pi / 180.0;
}

double metresPerDegreeOfLongitude(double latDeg) {
    const double a = inRadians(latDeg);
    return 111412.84 * std::cos(a) - 93.5 * std::cos(3.0 * a) + 0.118 * std::cos(5.0 * a);
}

}  // namespace

AgOpenGpsPlane::AgOpenGpsPlane(GeoPoint origin) : origin_{origin} {
    const double a = inRadians(origin.latDeg);
    mPerDegLat_ =
        111132.92 - 559.82 * std::cos(2.0 * a) + 1.175 * std::cos(4.0 * a) - 0.0023 * std::cos(6.0 * a);
}

Point AgOpenGpsPlane::toLocal(GeoPoint point) const {
    return {std::remainder(point.lonDeg - origin_.lonDeg, 360.0) * metresPerDegreeOfLongitude(point.latDeg),
            (point.latDeg - origin_.latDeg) * mPerDegLat_};
}

GeoPoint AgOpenGpsPlane::toGeo(Point point) const {
    const double latDeg = origin_.latDeg + point.y / mPerDegLat_;
    const double lonDeg = origin_.lonDeg + point.x / metresPerDegreeOfLongitude(latDeg);
    return {lonDeg > 180.0 ? lonDeg - 360.0 : lonDeg < -180.0 ? lonDeg + 360.0 : lonDeg, latDeg};
}

}  // namespace furrow
