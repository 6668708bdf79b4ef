#pragma once

#include "planner/core/file_in_memory.h"
#include "planner/core/geo_point.h"
#include "planner/core/result.h"
#include "planner/jobs/job.h"

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace furrow {

/// What GDAL writes: layers of one kind of shape each, with a table.
struct VectorLayer {
    enum class Shape { Polygons, Line, Point };
    enum class Kind { Text, Whole, Real };
    struct Column {
        std::string name;
        Kind kind = Kind::Text;
        int width = 0;     ///< characters or digits; 0 for the driver's own
        int decimals = 0;  ///< of Real, where a width is given
    };
    using Value = std::variant<std::string, std::int64_t, double>;
    struct Feature {
        std::vector<GeoPolygon> polygons;
        std::vector<GeoPoint> line;  ///< or the point alone
        std::vector<Value> values;   ///< one for each column
    };
    std::string name;
    Shape shape = Shape::Polygons;
    std::vector<Column> columns;
    std::vector<Feature> features;
};

enum class VectorFormat { Shapefile, GeoPackage };

/// The files of a dataset in WGS84, made in memory. A shapefile has a set of files for each layer, with .prj
/// and .cpg; a GeoPackage is one file called `name`. WriteFailed: GDAL's reason. Cancelled. Cost: linear, all
/// of it in memory.
Result<std::vector<FileInMemory>> vectorFiles(VectorFormat format, const std::string& name,
                                              std::span<const VectorLayer> layers, const JobContext& job);

}  // namespace furrow
