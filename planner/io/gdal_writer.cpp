#include "planner/io/gdal_writer.h"

#include "planner/gdal/drivers.h"
#include "planner/gdal/messages.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <format>
#include <memory>
#include <utility>

namespace furrow {

namespace {

Error writeFailed(Message what) {
    return {.code = ErrorCode::WriteFailed, .what = std::move(what), .where = "", .remedy = "choose another format"};
}

/// A folder in GDAL's memory that nobody else has.
class MemoryFolder {
public:
    MemoryFolder() {
        static std::atomic<unsigned> next{0};
        path_ = std::format("/vsimem/furrow_export_{}", next++);
        VSIMkdir(path_.c_str(), 0755);
    }
    ~MemoryFolder() { VSIRmdirRecursive(path_.c_str()); }
    MemoryFolder(const MemoryFolder&) = delete;
    MemoryFolder& operator=(const MemoryFolder&) = delete;

    std::string file(const std::string& name) const { return path_ + "/" + name; }
    const std::string& path() const { return path_; }

    std::string bytes(const std::string& name) const {
        vsi_l_offset size = 0;
        const GByte* start = VSIGetMemFileBuffer(file(name).c_str(), &size, FALSE);
        return start == nullptr ? std::string{}
                                : std::string{reinterpret_cast<const char*>(start), static_cast<std::size_t>(size)};
    }

private:
    std::string path_;
};

std::unique_ptr<OGRLinearRing> ringOf(const GeoRing& points) {
    auto ring = std::make_unique<OGRLinearRing>();
    for (const GeoPoint& point : points) {
        ring->addPoint(point.lonDeg, point.latDeg);
    }
    ring->closeRings();
    return ring;
}

std::unique_ptr<OGRPolygon> polygonOf(const GeoPolygon& polygon) {
    auto made = std::make_unique<OGRPolygon>();
    made->addRingDirectly(ringOf(polygon.outer).release());
    for (const GeoRing& hole : polygon.holes) {
        made->addRingDirectly(ringOf(hole).release());
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

bool addLayer(GDALDataset& dataset, const VectorLayer& layer, VectorFormat format, const JobContext& job) {
    OGRSpatialReference wgs84;
    wgs84.SetWellKnownGeogCS("WGS84");
    wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    CPLStringList options;
    if (format == VectorFormat::Shapefile) {
        options.SetNameValue("ENCODING", "UTF-8");
    }
    OGRLayer* made = dataset.CreateLayer(layer.name.c_str(), &wgs84, typeOf(layer), options.List());
    if (made == nullptr) {
        return false;
    }
    for (const VectorLayer::Column& column : layer.columns) {
        OGRFieldDefn definition{column.name.c_str(), column.kind == VectorLayer::Kind::Text    ? OFTString
                                                     : column.kind == VectorLayer::Kind::Whole ? OFTInteger64
                                                                                               : OFTReal};
        definition.SetWidth(column.width);
        definition.SetPrecision(column.decimals);
        if (made->CreateField(&definition) != OGRERR_NONE) {
            return false;
        }
    }
    for (const VectorLayer::Feature& feature : layer.features) {
        if (job.stopRequested()) {
            return false;
        }
        const OGRFeatureUniquePtr row{OGRFeature::CreateFeature(made->GetLayerDefn())};
        for (std::size_t i = 0; i < feature.values.size(); ++i) {
            const int at = static_cast<int>(i);
            std::visit(
                [&row, at](const auto& value) {
                    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>) {
                        row->SetField(at, value.c_str());
                    } else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::int64_t>) {
                        row->SetField(at, static_cast<GIntBig>(value));
                    } else {
                        row->SetField(at, value);
                    }
                },
                feature.values[i]);
        }
        row->SetGeometryDirectly(geometryOf(layer.shape, feature).release());
        if (made->CreateFeature(row.get()) != OGRERR_NONE) {
            return false;
        }
    }
    return true;
}

}  // namespace

Result<std::vector<FileToWrite>> vectorFiles(VectorFormat format, const std::string& name,
                                             std::span<const VectorLayer> layers, const JobContext& job) {
    registerGdalDrivers();
    const GdalMessages messages;
    const MemoryFolder memory;
    const bool isShapefile = format == VectorFormat::Shapefile;
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(isShapefile ? "ESRI Shapefile" : "GPKG");
    GDALDataset* dataset =
        driver == nullptr ? nullptr
                          : driver->Create((isShapefile ? memory.path() : memory.file(name)).c_str(), 0, 0, 0,
                                           GDT_Unknown, nullptr);
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
    std::vector<FileToWrite> files;
    for (const std::string& file : names) {
        files.push_back({file, [bytes = memory.bytes(file)] { return bytes; }});
    }
    return files;
}

Result<std::string> zipOf(std::span<const FileToWrite> files) {
    const GdalMessages messages;
    const MemoryFolder memory;
    void* zip = CPLCreateZip(memory.file("out.zip").c_str(), nullptr);
    bool good = zip != nullptr;
    for (const FileToWrite& file : files) {
        const std::string bytes = good ? file.text() : std::string{};
        // What is unsigned in zips is an int here; no file of ours comes near.
        good = good && CPLCreateFileInZip(zip, file.path.generic_string().c_str(), nullptr) == CE_None &&
               CPLWriteFileInZip(zip, bytes.data(), static_cast<int>(bytes.size())) == CE_None &&
               CPLCloseFileInZip(zip) == CE_None;
    }
    if (zip != nullptr) {
        good = CPLCloseZip(zip) == CE_None && good;
    }
    if (!good) {
        return std::unexpected(writeFailed(message("the zip cannot be made: {}", messages.failure())));
    }
    return memory.bytes("out.zip");
}

std::vector<std::pair<std::string, std::string>> filesInZip(std::string_view zip) {
    registerGdalDrivers();
    const GdalMessages messages;
    const MemoryFolder memory;
    const std::string path = memory.file("in.zip");
    const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> out{VSIFOpenL(path.c_str(), "wb"), VSIFCloseL};
    if (!out || VSIFWriteL(zip.data(), 1, zip.size(), out.get()) != zip.size() || VSIFFlushL(out.get()) != 0) {
        return {};
    }
    const std::string root = "/vsizip/{" + path + "}";
    std::vector<std::pair<std::string, std::string>> files;
    const CPLStringList names{VSIReadDirRecursive(root.c_str())};
    for (int i = 0; i < names.size(); ++i) {
        const std::string name = names[i];
        GByte* read = nullptr;
        vsi_l_offset size = 0;
        if (!name.ends_with('/') && VSIIngestFile(nullptr, (root + "/" + name).c_str(), &read, &size, -1) != 0) {
            files.emplace_back(name, std::string{reinterpret_cast<const char*>(read), static_cast<std::size_t>(size)});
        }
        VSIFree(read);
    }
    return files;
}

UtmZone UtmZone::of(GeoPoint place) {
    const int zone = std::clamp(static_cast<int>(std::floor((place.lonDeg + 180.0) / 6.0)) + 1, 1, 60);
    return {(place.latDeg < 0.0 ? 32700 : 32600) + zone};
}

namespace {

/// Coordinates of one system in another, in place. False where one of them has no place there.
bool transform(int fromEpsg, int toEpsg, std::vector<double>& x, std::vector<double>& y) {
    registerGdalDrivers();
    const GdalMessages messages;
    OGRSpatialReference from;
    OGRSpatialReference to;
    if (from.importFromEPSG(fromEpsg) != OGRERR_NONE || to.importFromEPSG(toEpsg) != OGRERR_NONE) {
        return false;
    }
    from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation, decltype(&OGRCoordinateTransformation::DestroyCT)> made{
        OGRCreateCoordinateTransformation(&from, &to), &OGRCoordinateTransformation::DestroyCT};
    return made && (x.empty() || made->Transform(x.size(), x.data(), y.data()) != 0);
}

constexpr int kWgs84 = 4326;

}  // namespace

Result<std::vector<std::pair<double, double>>> UtmZone::project(std::span<const GeoPoint> points) const {
    std::vector<double> x;
    std::vector<double> y;
    for (const GeoPoint& point : points) {
        x.push_back(point.lonDeg);
        y.push_back(point.latDeg);
    }
    if (!transform(kWgs84, epsg, x, y)) {
        return std::unexpected(writeFailed(message("a point has no place in EPSG:{}", epsg)));
    }
    std::vector<std::pair<double, double>> projected;
    for (std::size_t i = 0; i < x.size(); ++i) {
        projected.emplace_back(x[i], y[i]);
    }
    return projected;
}

Result<GeoRing> UtmZone::unproject(std::span<const std::pair<double, double>> places) const {
    std::vector<double> x;
    std::vector<double> y;
    for (const auto& [east, north] : places) {
        x.push_back(east);
        y.push_back(north);
    }
    if (!transform(epsg, kWgs84, x, y)) {
        return std::unexpected(writeFailed(message("a point has no place in EPSG:{}", epsg)));
    }
    GeoRing points;
    for (std::size_t i = 0; i < x.size(); ++i) {
        points.push_back({x[i], y[i]});
    }
    return points;
}

}  // namespace furrow
