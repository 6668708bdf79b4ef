#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"

#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <memory>
#include <string>
#include <vector>

namespace furrow {

struct TransformCloser {
    void operator()(OGRCoordinateTransformation* transform) const {
        OGRCoordinateTransformation::DestroyCT(transform);
    }
};
using Transform = std::unique_ptr<OGRCoordinateTransformation, TransformCloser>;

/// WGS84 with the longitude first.
OGRSpatialReference wgs84System();

/// From a layer's coordinates to WGS84.
class ToWgs84 {
public:
    /// Without a coordinate system the coordinates are taken for longitude and latitude; see checkDegrees.
    ///
    /// @return InputRefused: there is no way from it to WGS84.
    static Result<ToWgs84> from(const OGRSpatialReference* source, const std::string& where);

    /// Not finite where a point has no place in WGS84.
    GeoRing points(const OGRSimpleCurve& line) const;
    GeoPoint point(const OGRPoint& point) const;

    /// The coordinate system of the source is known.
    bool known() const { return known_; }

private:
    GeoRing converted(std::vector<double>& x, std::vector<double>& y) const;

    bool known_ = false;
    Transform transform_;  ///< none where nothing has to be converted
};

}  // namespace furrow
