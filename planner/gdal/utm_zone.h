#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"

#include <span>
#include <utility>
#include <vector>

namespace furrow {

/// A UTM zone and the way into it.
struct UtmZone {
    int epsg = 0;  ///< 32601 to 32660, 32701 to 32760

    static UtmZone of(GeoPoint place);
    /// East and north in metres, in the order of the points. WriteFailed: a point that has no place there.
    Result<std::vector<std::pair<double, double>>> project(std::span<const GeoPoint> points) const;
    /// The same back.
    Result<GeoRing> unproject(std::span<const std::pair<double, double>> places) const;
};

}  // namespace furrow
