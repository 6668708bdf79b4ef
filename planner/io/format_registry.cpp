#include "planner/io/format_registry.h"

#include <format>
#include <string>

namespace furrow {

namespace {

constexpr FormatInfo kFormats[] = {
    {"geojson", "GeoJSON", "geojson json", true, true,
     "Boundary, obstacles, swaths, path and findings of a plan."},
    {"csv", "CSV table", "csv", true, true,
     "Every sample of the path; reading: a WKT column or lon and lat columns."},
    {"isoxml", "ISOXML v4", "xml", false, true,
     "Boundary, holes and AB lines for terminals; no driving order."},
    {"shapefile", "Shapefile, also zipped", "shp zip", true, false, "Boundaries."},
    {"kml", "KML", "kml", true, false, "Boundaries."},
    {"kmz", "KMZ", "kmz", true, false, "Boundaries."},
    {"geopackage", "GeoPackage", "gpkg", true, false, "Boundaries."},
    {"gml", "GML", "gml", true, false, "Boundaries."},
    {"flatgeobuf", "FlatGeobuf", "fgb", true, false, "Boundaries."},
    {"wkt", "Well-known text", "wkt txt", true, false, "Boundaries in longitude and latitude."},
};

}  // namespace

std::span<const FormatInfo> formats() {
    return kFormats;
}

Result<const FormatInfo*> findPlanFormat(std::string_view id) {
    std::string known;
    for (const FormatInfo& format : kFormats) {
        if (format.write && format.id == id) {
            return &format;
        }
        if (format.write) {
            known += (known.empty() ? "" : ", ") + std::string{format.id};
        }
    }
    return std::unexpected(Error{.code = ErrorCode::Usage,
                                 .what = std::format("plans cannot be written as '{}'", id),
                                 .where = "--format",
                                 .remedy = "use one or more of: " + known});
}

}  // namespace furrow
