#include "planner/gdal/vector_writer.h"

#include "planner/gdal/drivers.h"
#include "planner/gdal/memory_folder.h"
#include "planner/gdal/messages.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace furrow {

namespace {

Error writeFailed(Message what) {
    return {.code = ErrorCode::WriteFailed,
            .what = std::move(what),
            .where = "",
            .remedy = "choose another format"};
}

std::unique_ptr<OGRLinearRing> ogrRing(const GeoRing& points) {
    auto ring = std::make_unique<OGRLinearRing>();
    for (const GeoPoint& point : points) {
        ring->addPoint(point.lonDeg, point.latDeg);
    }
    ring->closeRings();
    return ring;
}

std::unique_ptr<OGRPolygon> polygonOf(const GeoPolygon& polygon) {
    auto made = std::make_unique<OGRPolygon>();
    made->addRingDirectly(ogrRing(polygon.outer).release());
    for (const GeoRing& hole : polygon.holes) {
        made->addRingDirectly(ogrRing(hole).release());
    }
    return made;
}

std::unique_ptr<OGRGeometry> geometryOf(VectorLayer::Shape shape, const VectorLayer::Feature& feature) {
    if (shape == VectorLayer::Shape::Point) {
        return std::make_unique<OGRPoint>(feature.line.front().lonDeg, feature.line.front().latDeg);
    }
    if (shape == VectorLayer::Shape::Line) {
        auto line = std::make_unique<OGRLineString>();
        for (const GeoPoint& point : feature.line) {
            line->addPoint(point.lonDeg, point.latDeg);
        }
        return line;
    }
    if (feature.polygons.size() == 1) {
        return polygonOf(feature.polygons.front());
    }
    auto all = std::make_unique<OGRMultiPolygon>();
    for (const GeoPolygon& polygon : feature.polygons) {
        all->addGeometryDirectly(polygonOf(polygon).release());
    }
    return all;
}

OGRwkbGeometryType typeOf(const VectorLayer& layer) {
    switch (layer.shape) {
        case VectorLayer::Shape::Point: return wkbPoint;
        case VectorLayer::Shape::Line: return wkbLineString;
        case VectorLayer::Shape::Polygons: break;
    }
    const bool several = std::ranges::any_of(
        layer.features, [](const VectorLayer::Feature& feature) { return feature.polygons.size() > 1; });
    return several ? wkbMultiPolygon : wkbPolygon;
}

bool addColumns(OGRLayer& made, const VectorLayer& layer) {
    for (const VectorLayer::Column& column : layer.columns) {
        OGRFieldDefn definition{column.name.c_str(), column.kind == VectorLayer::Kind::Text    ? OFTString
                                                     : column.kind == VectorLayer::Kind::Whole ? OFTInteger64
                                                                                               : OFTReal};
        definition.SetWidth(column.width);
        definition.SetPrecision(column.decimals);
        if (made.CreateField(&definition) != OGRERR_NONE) {
            return false;
        }
    }
    return true;
}

void setValue(OGRFeature& row, int column, const VectorLayer::Value& value) {
    std::visit(
        [&row, column](const auto& each) {
            if constexpr (std::is_same_v<std::decay_t<decltype(each)>, std::string>) {
                row.SetField(column, each.c_str());
            } else if constexpr (std::is_same_v<std::decay_t<decltype(each)>, std::int64_t>) {
                row.SetField(column, static_cast<GIntBig>(each));
            } else {
                row.SetField(column, each);
            }
        },
        value);
}

bool addLayer(GDALDataset& dataset, const VectorLayer& layer, VectorFormat format, const JobContext& job) {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    CPLStringList options;
    if (format == VectorFormat::Shapefile) {
        options.SetNameValue("ENCODING", "UTF-8");
        options.SetNameValue("DBF_DATE_LAST_UPDATE", "2000-01-01");
    }
    OGRLayer* made = dataset.CreateLayer(layer.name.c_str(), &wgs84, typeOf(layer), options.List());
    if (made == nullptr || !addColumns(*made, layer)) {
        return false;
    }
    for (const VectorLayer::Feature& feature : layer.features) {
        if (job.stopRequested()) {
            return false;
        }
        const OGRFeatureUniquePtr row{OGRFeature::CreateFeature(made->GetLayerDefn())};
        for (std::size_t i = 0; i < feature.values.size(); ++i) {
            setValue(*row, static_cast<int>(i), feature.values[i]);
        }
        row->SetGeometryDirectly(geometryOf(layer.shape, feature).release());
        if (made->CreateFeature(row.get()) != OGRERR_NONE) {
            return false;
        }
    }
    return true;
}

/// The same plan gives the same bytes: a GeoPackage does not say when it was made.
class FixedDate {
public:
    FixedDate() { CPLSetThreadLocalConfigOption(kOption, "2000-01-01T00:00:00.000Z"); }
    ~FixedDate() { CPLSetThreadLocalConfigOption(kOption, nullptr); }
    FixedDate(const FixedDate&) = delete;
    FixedDate& operator=(const FixedDate&) = delete;

private:
    static constexpr const char* kOption = "OGR_CURRENT_DATE";
};

}  // namespace

Result<std::vector<FileInMemory>> vectorFiles(VectorFormat format, const std::string& name,
                                              std::span<const VectorLayer> layers, const JobContext& job) {
    registerGdalDrivers();
    const GdalMessages messages;
    const MemoryFolder memory;
    const FixedDate date;
    const bool isShapefile = format == VectorFormat::Shapefile;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(isShapefile ? "ESRI Shapefile" : "GPKG");
    GDALDataset* dataset = driver == nullptr
                               ? nullptr
                               : driver->Create((isShapefile ? memory.path() : memory.file(name)).c_str(), 0,
                                                0, 0, GDT_Unknown, nullptr);
    bool good = dataset != nullptr;
    for (std::size_t i = 0; good && i < layers.size(); ++i) {
        good = addLayer(*dataset, layers[i], format, job);
    }
    if (dataset != nullptr) {
        good = GDALClose(dataset) == CE_None && good;
    }
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    if (!good) {
        return std::unexpected(writeFailed(message("{} cannot be made: {}", name, messages.failure())));
    }
    std::vector<std::string> names;
    const CPLStringList listed{VSIReadDir(memory.path().c_str())};
    for (int i = 0; i < listed.size(); ++i) {
        names.emplace_back(listed[i]);
    }
    std::ranges::sort(names);
    std::vector<FileInMemory> files;
    for (const std::string& file : names) {
        files.push_back({file, memory.bytes(file)});
    }
    return files;
}

}  // namespace furrow
