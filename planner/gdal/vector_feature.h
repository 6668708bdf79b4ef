#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"

#include <string>
#include <vector>

namespace furrow {

/// One feature of a vector file, in WGS84: curves as short chords, heights left out, rings not closed.
/// Coordinates that are not finite, or that have no place in WGS84, are kept as not finite.
struct VectorFeature {
    std::vector<GeoPolygon> polygons;
    std::vector<GeoRing> closedLines;  ///< lines that end where they begin
    std::vector<GeoPoint> points;
    std::vector<GeoRing> openLines;       ///< at least two points
    std::vector<GeoPoint> openRings;      ///< where rings of the polygons begin that do not end there
    std::string key;                      ///< the file's own id of it; empty where it has none
    std::vector<std::string> attributes;  ///< in the order they were asked for; empty where there is none

    bool hasGeometry() const {
        return !polygons.empty() || !closedLines.empty() || !points.empty() || !openLines.empty();
    }
};

struct VectorFile {
    bool isTable = false;                 ///< CSV: geometry may be spread over columns and rows
    bool isTrack = false;                 ///< GPX: lines are what was driven or walked
    std::vector<std::string> columns;     ///< of a table: what its first row calls them
    std::vector<VectorFeature> features;  ///< of all layers, in the order of the file
};

/// Of a file that does not say which coordinate system it uses. InputRefused: a finite point of the feature
/// is no longitude and latitude.
Result<void> checkDegrees(const VectorFeature& feature, const std::string& where);

}  // namespace furrow
