#include "planner/gdal/vector_dataset.h"

#include "planner/core/file_error.h"
#include "planner/core/json_text.h"
#include "planner/core/text.h"
#include "planner/gdal/feature_shapes.h"
#include "planner/gdal/system_files.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <utility>

namespace furrow {

namespace {

// Only these: others may follow references to elsewhere (VRT, WFS) or run for ever on the wrong input.
constexpr const char* kVectorDrivers[] = {"GeoJSON",        "GeoJSONSeq",  "JSONFG", "TopoJSON", "ESRIJSON",
                                          "ESRI Shapefile", "LIBKML",      "KML",    "GPKG",     "GML",
                                          "FlatGeobuf",     "OpenFileGDB", "CSV",    "GPX",      "DXF",
                                          nullptr};
constexpr const char* kPlainKml[] = {"KML", nullptr};

constexpr std::pair<const char*, const char*> kThreadOptions[] = {
    {"SHAPE_RESTORE_SHX", "NO"},        // would write beside the user's file
    {"GML_SKIP_RESOLVE_ELEMS", "ALL"},  // would follow links
};

/// The id that a GeoJSON feature carries beside its properties, or the number in a table's id column.
std::string keyOf(const OGRFeature& feature, const std::string& fidColumn) {
    const char* native = feature.GetNativeData();
    if (native != nullptr) {
        const nlohmann::json json = jsonOrDiscarded<nlohmann::json>(native);
        if (json.is_object() && json.contains("id")) {
            const nlohmann::json& id = json["id"];
            return id.is_string() ? id.get<std::string>() : id.is_number() ? id.dump() : std::string{};
        }
        return {};
    }
    return fidColumn.empty() ? std::string{} : std::to_string(feature.GetFID());
}

/// Empty for a column that is not there; of a list its first entry.
std::string textOf(const OGRFeature& feature, int column) {
    if (column < 0 || !feature.IsFieldSetAndNotNull(column)) {
        return {};
    }
    if (feature.GetFieldDefnRef(column)->GetType() == OFTStringList) {
        char** list = feature.GetFieldAsStringList(column);
        return list == nullptr || *list == nullptr ? std::string{} : std::string{*list};
    }
    return feature.GetFieldAsString(column);
}

/// "EPSG" and a code in a file's name; empty where there is none.
OGRSpatialReference systemInName(const std::string& name) {
    OGRSpatialReference system;
    const std::size_t at = inSmallLetters(name).rfind("epsg");
    std::size_t begin = at == std::string::npos ? name.size() : at + 4;
    begin += begin < name.size() && (name[begin] == '_' || name[begin] == '-') ? 1 : 0;
    int code = 0;
    const auto [end, error] = std::from_chars(name.data() + begin, name.data() + name.size(), code);
    if (error == std::errc{} && code > 0 && system.importFromEPSG(code) == OGRERR_NONE) {
        system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    }
    return system;
}

Result<void> readFeatures(OGRLayer& layer, const std::string& name, const ToWgs84& toWgs84,
                          const GdalMessages& messages, const VectorReading& reading) {
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    std::vector<int> columns;
    for (const std::string_view attribute : reading.attributes) {
        columns.push_back(definition.GetFieldIndex(std::string{attribute}.c_str()));
    }
    const std::string fidColumn = layer.GetFIDColumn();
    layer.ResetReading();
    while (const OGRFeatureUniquePtr read{layer.GetNextFeature()}) {
        if (reading.job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        VectorFeature feature;
        feature.key = keyOf(*read, fidColumn);
        for (const int column : columns) {
            feature.attributes.push_back(textOf(*read, column));
        }
        if (const OGRGeometry* geometry = read->GetGeometryRef()) {
            if (auto added = addShapes(*geometry, toWgs84, feature, name); !added) {
                return added;
            }
        }
        reading.file.features.push_back(std::move(feature));
    }
    if (messages.failed()) {
        return std::unexpected(readFailed(name, message("the file is damaged ({})", messages.failure()),
                                          "export or copy it again"));
    }
    return {};
}

}  // namespace

VectorReadingOptions::VectorReadingOptions() {
    for (const auto& [key, value] : kThreadOptions) {
        CPLSetThreadLocalConfigOption(key, value);
    }
}

VectorReadingOptions::~VectorReadingOptions() {
    for (const auto& option : kThreadOptions) {
        CPLSetThreadLocalConfigOption(option.first, nullptr);
    }
}

void VectorDataset::Closer::operator()(GDALDataset* dataset) const {
    GDALClose(dataset);
}

VectorDataset::Dataset VectorDataset::openWith(const std::string& path, const char* const* drivers) {
    CPLStringList options;
    options.SetNameValue("NATIVE_DATA", "YES");     // GeoJSON: the feature's own id
    options.SetNameValue("WRITE_GFS", "NO");        // GML: nothing is written beside the file
    options.SetNameValue("DOWNLOAD_SCHEMA", "NO");  // GML
    options.SetNameValue("GEOM_POSSIBLE_NAMES", "WKT,geom,geometry,the_geom,polygon,boundary");  // CSV
    // GeoPackage: a view that is no layer may never end, and holds no fields.
    options.SetNameValue("LIST_ALL_TABLES", "NO");
    // SQLite would leave files beside a GeoPackage; unless there are changes still waiting in one.
    if (!systemFileExists(path + "-wal")) {
        options.SetNameValue("IMMUTABLE", "YES");
    }
    return Dataset{
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, options.List())};
}

std::optional<VectorDataset> VectorDataset::open(const std::string& path, GdalMessages& messages) {
    Dataset dataset = openWith(path, kVectorDrivers);
    // LIBKML refuses a KML without Document or Folder, which is legal; the plain driver reads it.
    if (inSmallLetters(path).ends_with(".kml") && (!dataset || dataset->GetLayerCount() == 0)) {
        messages.forget();
        if (Dataset plain = openWith(path, kPlainKml)) {
            return VectorDataset{std::move(plain)};
        }
    }
    return dataset ? std::optional{VectorDataset{std::move(dataset)}} : std::nullopt;
}

std::string VectorDataset::driver() const {
    return dataset_->GetDriverName();
}

bool VectorDataset::hasLayers() const {
    return dataset_->GetLayerCount() > 0;
}

std::vector<std::string> VectorDataset::columns() const {
    const OGRFeatureDefn& definition = *dataset_->GetLayer(0)->GetLayerDefn();
    std::vector<std::string> names;
    for (int i = 0; i < definition.GetFieldCount(); ++i) {
        names.emplace_back(definition.GetFieldDefn(i)->GetNameRef());
    }
    return names;
}

bool VectorDataset::lacksSystem() const {
    for (OGRLayer* layer : dataset_->GetLayers()) {
        if (layer->GetSpatialRef() == nullptr && layer->GetGeomType() != wkbNone) {
            return true;
        }
    }
    return false;
}

Result<void> VectorDataset::readLayers(const std::string& path, const std::string& name,
                                       const GdalMessages& messages, const VectorReading& reading) const {
    const OGRSpatialReference named = systemInName(name);
    const bool isDrawing = inSmallLetters(path).ends_with(".dxf");
    for (OGRLayer* layer : dataset_->GetLayers()) {
        if (isDrawing && named.IsEmpty()) {
            return std::unexpected(
                inputRefused(name, "a drawing does not say which coordinate system it uses",
                             "put the EPSG code into its name, as in field_EPSG32632.dxf"));
        }
        const auto toWgs84 = ToWgs84::from(isDrawing ? &named : layer->GetSpatialRef(), name);
        if (!toWgs84) {
            return std::unexpected(toWgs84.error());
        }
        if (auto read = readFeatures(*layer, name, *toWgs84, messages, reading); !read) {
            return read;
        }
    }
    return {};
}

}  // namespace furrow
