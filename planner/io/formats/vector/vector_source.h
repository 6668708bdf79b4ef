#pragma once

#include "planner/core/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// What a remedy says where a file holds no boundary.
inline constexpr std::string_view kBoundaryFormats =
    "give GeoJSON, a shapefile (.shp or .zip), TASKDATA.XML, KML, KMZ, GeoPackage, GML, FlatGeobuf, DXF, WKT or CSV";

/// One file to read boundaries from: loose, or inside a zip.
struct VectorSource {
    std::string path;  ///< as GDAL opens it
    std::string name;  ///< as people know it
};

/// The files that are meant by the one that was chosen: itself, the shapes of the shapefile it belongs to,
/// the boundary files in a zip, or a file geodatabase (a folder).
///
/// @return at least one. ReadFailed: not on this computer, not there, not readable, a folder, nothing of use
/// in
///         a zip. InputRefused: empty. Cost: a listing of the zip.
Result<std::vector<VectorSource>> vectorSources(const std::filesystem::path& chosen);

}  // namespace furrow
