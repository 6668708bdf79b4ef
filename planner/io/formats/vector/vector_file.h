#pragma once

#include "planner/core/result.h"
#include "planner/gdal/vector_feature.h"
#include "planner/jobs/job.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace furrow {

/// Reads every feature of a file on this computer; nothing is fetched from a network and nothing is
/// written beside the file.
///
/// @param path        GeoJSON, Shapefile, KML, GeoPackage, GML, FlatGeobuf, GPX, file geodatabase, WKT,
///                    CSV or DXF, loose or zipped (KMZ included); any coordinate system. A DXF does not say
///                    its own: it is taken from the file's name ("..._EPSG32631.dxf")
/// @param attributes  names of the attributes to read, capitals or not
/// @return ReadFailed: not there, a folder, no known format, damaged. InputRefused: empty, coordinates
///         that are neither WGS84 nor of a stated system, a coordinate that is no number (with its
///         feature, part and vertex). Cancelled: asked between features.
/// Cost: linear in the size of the file, all of it in memory. Thread-safe.
Result<VectorFile> readVectorFile(const std::filesystem::path& path,
                                  std::span<const std::string_view> attributes, const JobContext& job);

}  // namespace furrow
