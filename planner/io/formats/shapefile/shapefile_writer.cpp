#include "planner/io/formats/shapefile/shapefile.h"

#include "planner/gdal/zip.h"
#include "planner/io/content/map_layers.h"
#include "planner/io/formats/shapefile/owner.h"

#include <utility>

namespace furrow {

namespace {

using Kind = VectorLayer::Kind;
using Shape = VectorLayer::Shape;

}  // namespace

Result<FormatFiles> writeShapefiles(const ExportJob& job) {
    return vectorFiles(VectorFormat::Shapefile, "shapefile", mapLayers(job), job.job)
        .transform(asFormatFiles);
}

Result<FormatFiles> writeBoundaryZip(const ExportJob& job) {
    VectorLayer layer{"boundary",
                      Shape::Polygons,
                      {{"CLIENT_NAM", Kind::Text, 32},
                       {"FARM_NAME", Kind::Text, 32},
                       {"FIELD_NAME", Kind::Text, 64},
                       {"POLYGONTYP", Kind::Whole, 4}},
                      {}};
    for (const FieldContent& content : job.fields) {
        layer.features.push_back({.polygons = content.field.parts,
                                  .values = {kClient, kFarm, content.field.name, std::int64_t{1}}});
    }
    return vectorFiles(VectorFormat::Shapefile, "boundary", {&layer, 1}, job.job)
        .and_then([](const std::vector<FileInMemory>& files) { return zipOf(files); })
        .transform([](std::string zip) {
            FormatFiles made;
            made.files.push_back(toWrite({"boundary.zip", std::move(zip)}));
            return made;
        });
}

}  // namespace furrow
