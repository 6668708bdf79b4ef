#include "planner/io/formats/geopackage/geopackage.h"

#include "planner/io/content/map_layers.h"

namespace furrow {

Result<FormatFiles> writeGeoPackage(const ExportJob& job) {
    return vectorFiles(VectorFormat::GeoPackage, "plan.gpkg", mapLayers(job), job.job)
        .transform(asFormatFiles);
}

}  // namespace furrow
