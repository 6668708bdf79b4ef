#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"
#include "planner/jobs/job.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// One feature of a vector file, in WGS84: curves as short chords, heights left out, rings not closed.
/// Coordinates that are not finite, or that have no place in WGS84, are kept as not finite.
struct VectorFeature {
    std::vector<GeoPolygon> polygons;
    std::vector<GeoRing> closedLines;  ///< lines that end where they begin
    std::vector<GeoPoint> points;
    std::vector<GeoRing> openLines;        ///< at least two points
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

/// Reads every feature of a file on this computer; nothing is fetched from a network and nothing is
/// written beside the file.
///
/// @param path        GeoJSON, Shapefile, KML, GeoPackage, GML, FlatGeobuf, GPX, file geodatabase, WKT,
///                    CSV or DXF, loose or zipped (KMZ included); any coordinate system. A DXF does not say its
///                    own: it is taken from the file's name ("..._EPSG32631.dxf")
/// @param attributes  names of the attributes to read, capitals or not
/// @return ReadFailed: not there, a folder, no known format, damaged. InputRefused: empty, coordinates
///         that are neither WGS84 nor of a stated system, a coordinate that is no number (with its
///         feature, part and vertex). Cancelled: asked between features.
/// Cost: linear in the size of the file, all of it in memory. Thread-safe.
Result<VectorFile> readVectorFile(const std::filesystem::path& path,
                                  std::span<const std::string_view> attributes, const JobContext& job);

}  // namespace furrow
