#include "planner/io/gdal_bridge.h"

#include "planner/core/file_error.h"
#include "planner/core/text_file.h"
#include "planner/gdal/drivers.h"
#include "planner/gdal/messages.h"
#include "planner/io/files/file_folder.h"
#include "planner/io/formats/geojson/geojson_check.h"
#include "planner/io/formats/geojson/geojson_crs.h"
#include "planner/io/formats/vector/vector_source.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <utility>

namespace furrow {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Two chords per 2 degrees of arc: 1.5 cm beside the circle of a centre pivot of 400 m radius.
constexpr double kArcStepDeg = 1.0;

// A millimetre on the ground.
constexpr double kSamePointDeg = 1e-8;

// Only these: others may follow references to elsewhere (VRT, WFS) or run for ever on the wrong input.
constexpr const char* kDrivers[] = {"GeoJSON",        "GeoJSONSeq",  "JSONFG", "TopoJSON", "ESRIJSON",
                                    "ESRI Shapefile", "LIBKML",      "KML",    "GPKG",     "GML",
                                    "FlatGeobuf",     "OpenFileGDB", "CSV",    "GPX",      "DXF",
                                    nullptr};
constexpr const char* kPlainKml[] = {"KML", nullptr};

/// GDAL's options for this thread, put back afterwards.
class ThreadOptions {
public:
    ThreadOptions() {
        for (const auto& [key, value] : kOptions) {
            CPLSetThreadLocalConfigOption(key, value);
        }
    }
    ~ThreadOptions() {
        for (const auto& option : kOptions) {
            CPLSetThreadLocalConfigOption(option.first, nullptr);
        }
    }
    ThreadOptions(const ThreadOptions&) = delete;
    ThreadOptions& operator=(const ThreadOptions&) = delete;

private:
    static constexpr std::pair<const char*, const char*> kOptions[] = {
        {"SHAPE_RESTORE_SHX", "NO"},        // would write beside the user's file
        {"GML_SKIP_RESOLVE_ELEMS", "ALL"},  // would follow links
    };
};

struct DatasetCloser {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetCloser>;

struct TransformCloser {
    void operator()(OGRCoordinateTransformation* transform) const {
        OGRCoordinateTransformation::DestroyCT(transform);
    }
};
using Transform = std::unique_ptr<OGRCoordinateTransformation, TransformCloser>;

std::string_view withoutBlanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

// --- Geometry ---------------------------------------------------------------------------------------

/// From a layer's coordinates to WGS84.
class ToWgs84 {
public:
    /// Without a coordinate system longitude and latitude are assumed, and checked by `checkRange`.
    static Result<ToWgs84> from(const OGRSpatialReference* source, const std::string& where) {
        ToWgs84 made;
        made.known_ = isKnown(source);
        if (!made.known_) {
            return made;
        }
        OGRSpatialReference wgs84;
        wgs84.SetWellKnownGeogCS("WGS84");
        wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        if (source->IsSame(&wgs84) != 0) {
            return made;  // the numbers of the file to the last bit
        }
        made.transform_.reset(OGRCreateCoordinateTransformation(source, &wgs84));
        if (!made.transform_) {
            const char* name = source->GetName();
            return std::unexpected(
                inputRefused(where,
                             message("its coordinate system '{}' cannot be turned into WGS84",
                                         name == nullptr ? "" : name),
                             "export the field again in WGS84 (longitude and latitude)"));
        }
        return made;
    }

    GeoRing points(const OGRSimpleCurve& line) const {
        const auto count = static_cast<std::size_t>(line.getNumPoints());
        std::vector<double> x(count);
        std::vector<double> y(count);
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = line.getX(static_cast<int>(i));
            y[i] = line.getY(static_cast<int>(i));
        }
        return converted(x, y);
    }

    GeoPoint point(const OGRPoint& point) const {
        std::vector<double> x{point.getX()};
        std::vector<double> y{point.getY()};
        return converted(x, y).front();
    }

    bool known() const { return known_; }

private:
    static bool isKnown(const OGRSpatialReference* source) {
        if (source == nullptr || source->IsEmpty() || source->IsLocal()) {
            return false;
        }
        const char* name = source->GetName();
        // GeoPackage's own way to say that the system is not known.
        return name == nullptr || !std::string_view{name}.starts_with("Undefined");
    }

    GeoRing converted(std::vector<double>& x, std::vector<double>& y) const {
        if (transform_ && !x.empty()) {
            std::vector<int> good(x.size(), 1);
            // What cannot be converted is told by the place of the point, not by a message.
            CPLPushErrorHandler(CPLQuietErrorHandler);
            transform_->Transform(x.size(), x.data(), y.data(), nullptr, good.data());
            CPLPopErrorHandler();
            for (std::size_t i = 0; i < x.size(); ++i) {
                if (good[i] == 0) {
                    x[i] = kNaN;
                    y[i] = kNaN;
                }
            }
        }
        GeoRing ring;
        ring.reserve(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            ring.push_back({x[i], y[i]});
        }
        return ring;
    }

    bool known_ = false;
    Transform transform_;
};

bool isClosed(const OGRSimpleCurve& line) {
    const int last = line.getNumPoints() - 1;
    return last >= 1 && line.getX(0) == line.getX(last) && line.getY(0) == line.getY(last);
}

GeoRing ringOf(const OGRSimpleCurve& line, const ToWgs84& toWgs84) {
    GeoRing ring = toWgs84.points(line);
    if (isClosed(line)) {
        ring.pop_back();
    }
    return ring;
}

/// Of a polygon, whose rings have to end where they begin.
GeoRing polygonRing(const OGRLinearRing& line, const ToWgs84& toWgs84, VectorFeature& feature) {
    GeoRing ring = ringOf(line, toWgs84);
    const bool ends = isClosed(line) || (std::abs(ring.back().lonDeg - ring.front().lonDeg) < kSamePointDeg &&
                                         std::abs(ring.back().latDeg - ring.front().latDeg) < kSamePointDeg);
    if (!ends) {
        feature.openRings.push_back(ring.front());
    }
    return ring;
}

void addPolygon(const OGRPolygon& polygon, const ToWgs84& toWgs84, VectorFeature& feature) {
    const OGRLinearRing* outer = polygon.getExteriorRing();
    if (outer == nullptr || outer->getNumPoints() == 0) {
        return;
    }
    GeoPolygon added{.outer = polygonRing(*outer, toWgs84, feature), .holes = {}};
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
        if (polygon.getInteriorRing(i)->getNumPoints() > 0) {
            added.holes.push_back(polygonRing(*polygon.getInteriorRing(i), toWgs84, feature));
        }
    }
    feature.polygons.push_back(std::move(added));
}

void addGeometry(const OGRGeometry& geometry, const ToWgs84& toWgs84, VectorFeature& feature) {
    if (geometry.hasCurveGeometry() != 0) {
        const std::unique_ptr<OGRGeometry> chords{geometry.getLinearGeometry(kArcStepDeg)};
        if (chords) {
            addGeometry(*chords, toWgs84, feature);
        }
        return;
    }
    switch (wkbFlatten(geometry.getGeometryType())) {
        case wkbPolygon:
        case wkbTriangle: addPolygon(*geometry.toPolygon(), toWgs84, feature); break;
        case wkbMultiPolygon:
        case wkbMultiLineString:
        case wkbMultiPoint:
        case wkbGeometryCollection:
            for (const OGRGeometry* member : *geometry.toGeometryCollection()) {
                addGeometry(*member, toWgs84, feature);
            }
            break;
        case wkbPolyhedralSurface:
        case wkbTIN:
            for (const OGRPolygon* member : *geometry.toPolyhedralSurface()) {
                addPolygon(*member, toWgs84, feature);
            }
            break;
        case wkbLineString: {
            const OGRLineString& line = *geometry.toLineString();
            if (line.getNumPoints() >= 4 && isClosed(line)) {
                feature.closedLines.push_back(ringOf(line, toWgs84));
            } else if (line.getNumPoints() > 1) {
                feature.openLines.push_back(toWgs84.points(line));
            }
            break;
        }
        case wkbPoint:
            if (geometry.IsEmpty() == 0) {
                feature.points.push_back(toWgs84.point(*geometry.toPoint()));
            }
            break;
        default: break;
    }
}

Result<void> checkRange(const VectorFeature& feature, const ToWgs84& toWgs84, const std::string& where) {
    return toWgs84.known() ? Result<void>{} : checkDegrees(feature, where);
}

// --- One source -------------------------------------------------------------------------------------

/// Everything a reader of one source needs.
struct Reading {
    std::span<const std::string_view> attributes;
    const JobContext& job;
    VectorFile& file;
};

/// Of a text that GDAL could not open.
Result<void> checkUnopened(const BoundarySource& source) {
    const auto text = systemFileBytes(source.path, source.name);
    return text ? checkGeoJson(*text, source.name, false) : Result<void>{};
}

/// What GDAL leaves out, or makes up, in an opened GeoJSON file. Nothing is assumed in the place of a coordinate
/// system that it makes nothing of.
Result<void> checkOpened(const BoundarySource& source, GDALDataset& dataset) {
    const std::string driver = dataset.GetDriverName();
    if (driver != "GeoJSON" && driver != "GeoJSONSeq" && driver != "JSONFG") {
        return {};
    }
    const auto text = systemFileBytes(source.path, source.name);
    if (!text) {
        return std::unexpected(text.error());
    }
    const auto checked = driver == "GeoJSON" ? checkGeoJson(*text, source.name, true) : Result<void>{};
    const auto isNull = checked.and_then([&] { return checkCrs(*text, driver == "GeoJSONSeq", source.name); });
    if (!isNull) {
        return std::unexpected(isNull.error());
    }
    for (OGRLayer* layer : dataset.GetLayers()) {
        if (layer->GetSpatialRef() == nullptr && layer->GetGeomType() != wkbNone && !*isNull) {
            return std::unexpected(inputRefused(source.name, "the coordinate system that it names is not known",
                                                "export the field again in WGS84 (longitude and latitude)"));
        }
    }
    return {};
}

Dataset openWith(const std::string& path, const char* const* drivers) {
    CPLStringList options;
    options.SetNameValue("NATIVE_DATA", "YES");     // GeoJSON: the feature's own id
    options.SetNameValue("WRITE_GFS", "NO");        // GML: nothing is written beside the file
    options.SetNameValue("DOWNLOAD_SCHEMA", "NO");  // GML
    options.SetNameValue("GEOM_POSSIBLE_NAMES", "WKT,geom,geometry,the_geom,polygon,boundary");  // CSV
    // SQLite would leave files beside a GeoPackage; unless there are changes still waiting in one.
    VSIStatBufL status;
    if (VSIStatL((path + "-wal").c_str(), &status) != 0) {
        options.SetNameValue("IMMUTABLE", "YES");
    }
    return Dataset{
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, options.List())};
}

/// LIBKML refuses a KML without Document or Folder, which is legal; the plain driver reads it.
Dataset openDataset(const std::string& path, GdalMessages& messages) {
    Dataset dataset = openWith(path, kDrivers);
    if (extensionInSmallLetters(path) == ".kml" && (!dataset || dataset->GetLayerCount() == 0)) {
        messages.forget();
        if (Dataset plain = openWith(path, kPlainKml)) {
            return plain;
        }
    }
    return dataset;
}

/// The id that a GeoJSON feature carries beside its properties, or the number in a table's id column.
std::string keyOf(const OGRFeature& feature, const std::string& fidColumn) {
    const char* native = feature.GetNativeData();
    if (native != nullptr) {
        const nlohmann::json json = nlohmann::json::parse(native, nullptr, false);
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

Result<void> readLayer(OGRLayer& layer, const BoundarySource& source, const GdalMessages& messages,
                       const Reading& reading) {
    const OGRSpatialReference named = systemInName(source.name);
    const bool isDrawing = extensionInSmallLetters(source.path) == ".dxf";
    if (isDrawing && named.IsEmpty()) {
        return std::unexpected(inputRefused(source.name, "a drawing does not say which coordinate system it uses",
                                            "put the EPSG code into its name, as in field_EPSG32632.dxf"));
    }
    const Result<ToWgs84> toWgs84 = ToWgs84::from(isDrawing ? &named : layer.GetSpatialRef(), source.name);
    if (!toWgs84) {
        return std::unexpected(toWgs84.error());
    }
    const OGRFeatureDefn& definition = *layer.GetLayerDefn();
    std::vector<int> columns;
    for (const std::string_view name : reading.attributes) {
        columns.push_back(definition.GetFieldIndex(std::string{name}.c_str()));
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
            addGeometry(*geometry, *toWgs84, feature);
        }
        if (auto checked = checkRange(feature, *toWgs84, source.name); !checked) {
            return checked;
        }
        reading.file.features.push_back(std::move(feature));
    }
    if (messages.failed()) {
        return std::unexpected(readFailed(source.name,
                                          message("the file is damaged ({})", messages.failure()),
                                          "export or copy it again"));
    }
    return {};
}

bool looksLikeWkt(std::string_view start) {
    const std::string small = inSmallLetters(withoutBlanks(withoutByteOrderMark(start)).substr(0, 32));
    constexpr std::string_view kWords[] = {"polygon",      "multipolygon",       "curvepolygon",
                                           "multisurface", "geometrycollection", "srid="};
    return std::ranges::any_of(kWords, [&small](std::string_view word) { return small.starts_with(word); });
}

/// One or more geometries in well-known text, one after the other; "SRID=25832;" before one is understood.
Result<void> readWkt(const BoundarySource& source, const Reading& reading) {
    const auto text = systemFileBytes(source.path, source.name);
    if (!text) {
        return std::unexpected(text.error());
    }
    std::size_t at = text->size() - withoutByteOrderMark(*text).size();
    while (true) {
        at = text->find_first_not_of(" \t\r\n;,\"", at);
        if (at == std::string::npos) {
            return {};
        }
        if (reading.job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const Message place = message("{}, {}", source.name, lineAndColumn(*text, at));
        OGRSpatialReference system;
        if (inSmallLetters(std::string_view{*text}.substr(at, 5)) == "srid=") {
            int code = 0;
            const char* end = text->data() + text->size();
            const auto [next, error] = std::from_chars(text->data() + at + 5, end, code);
            if (error != std::errc{} || next == end || *next != ';' ||
                (code != 0 && system.importFromEPSG(code) != OGRERR_NONE)) {
                return std::unexpected(
                    inputRefused(place, "the number after SRID= is no coordinate system that is known",
                                 "give an EPSG code, as in SRID=4326;POLYGON(...)"));
            }
            system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
            at = static_cast<std::size_t>(next - text->data()) + 1;
        }
        const char* rest = text->c_str() + at;
        OGRGeometry* made = nullptr;
        const OGRErr error = OGRGeometryFactory::createFromWkt(&rest, nullptr, &made);
        const std::unique_ptr<OGRGeometry> geometry{made};
        if (error != OGRERR_NONE || !geometry) {
            return std::unexpected(
                inputRefused(place, "this is not well-known text from here on",
                             "write POLYGON((lon lat, lon lat, ...)), one polygon a line"));
        }
        const Result<ToWgs84> toWgs84 = ToWgs84::from(&system, source.name);
        if (!toWgs84) {
            return std::unexpected(toWgs84.error());
        }
        VectorFeature feature;
        feature.attributes.resize(reading.attributes.size());
        addGeometry(*geometry, *toWgs84, feature);
        if (auto checked = checkRange(feature, *toWgs84, place); !checked) {
            return checked;
        }
        reading.file.features.push_back(std::move(feature));
        at = static_cast<std::size_t>(rest - text->c_str());
    }
}

/// The name of what this element belongs to: a child `name` of one of its ancestors.
std::string nameAround(pugi::xml_node node) {
    for (pugi::xml_node around = node.parent(); around; around = around.parent()) {
        if (const pugi::xml_node name = around.child("name")) {
            return name.text().as_string();
        }
    }
    return {};
}

/// Polygon elements of an XML document that its driver makes no layers of: field files of Fields2Cover,
/// KML without the element kml. (Polygons of KML and of GML 2 are written alike.)
Result<void> readLoosePolygons(const BoundarySource& source, const Reading& reading) {
    const auto text = systemFileBytes(source.path, source.name);
    if (!text) {
        return std::unexpected(text.error());
    }
    pugi::xml_document document;
    if (const pugi::xml_parse_result parsed = document.load_buffer(text->data(), text->size()); !parsed) {
        return std::unexpected(readFailed(
            message("{}, {}", source.name, lineAndColumn(*text, static_cast<std::size_t>(parsed.offset))),
            "this is not XML from here on", "the file may be cut off or damaged; export it again"));
    }
    const auto nameColumn = std::ranges::find(reading.attributes, "name") - reading.attributes.begin();
    for (const pugi::xpath_node& found : document.select_nodes("//*[local-name()='Polygon']")) {
        std::ostringstream gml;
        found.node().print(gml, "", pugi::format_raw);
        const std::unique_ptr<OGRGeometry> geometry{OGRGeometryFactory::createFromGML(gml.str().c_str())};
        if (!geometry) {
            return std::unexpected(inputRefused(
                message("{}, {}", source.name,
                            lineAndColumn(*text, static_cast<std::size_t>(found.node().offset_debug()))),
                "this polygon cannot be read", "check its coordinates"));
        }
        const Result<ToWgs84> toWgs84 = ToWgs84::from(geometry->getSpatialReference(), source.name);
        if (!toWgs84) {
            return std::unexpected(toWgs84.error());
        }
        VectorFeature feature;
        feature.attributes.resize(reading.attributes.size());
        if (std::cmp_less(nameColumn, reading.attributes.size())) {
            feature.attributes[static_cast<std::size_t>(nameColumn)] = nameAround(found.node());
        }
        addGeometry(*geometry, *toWgs84, feature);
        if (auto checked = checkRange(feature, *toWgs84, source.name); !checked) {
            return checked;
        }
        reading.file.features.push_back(std::move(feature));
    }
    return {};
}

Result<void> readSource(const BoundarySource& source, const Reading& reading) {
    GdalMessages messages;
    const std::string start = systemFileStart(source.path, source.name, 4096).value_or("");
    const std::string extension = extensionInSmallLetters(source.path);
    if (extension == ".wkt" || looksLikeWkt(start)) {
        return readWkt(source, reading);
    }
    messages.forget();
    const Dataset dataset = openDataset(source.path, messages);
    if (!dataset) {
        if (withoutBlanks(withoutByteOrderMark(start)).starts_with('{')) {
            if (auto checked = checkUnopened(source); !checked) {
                return checked;
            }
        }
        if (extension == ".kml") {
            return readLoosePolygons(source, reading);
        }
        if (extension == ".shp") {
            VSIStatBufL status;
            const std::string index = CPLResetExtension(source.path.c_str(), "shx");
            const std::string indexInCapitals = CPLResetExtension(source.path.c_str(), "SHX");
            if (VSIStatL(index.c_str(), &status) != 0 && VSIStatL(indexInCapitals.c_str(), &status) != 0) {
                return std::unexpected(readFailed(source.name, "the .shx file that belongs to it is missing",
                                                  "keep the .shp, .shx, .dbf and .prj files together"));
            }
        }
        return std::unexpected(readFailed(
            source.name,
            messages.failed() ? message("no boundary can be read from this file ({})", messages.failure())
                              : "this is no boundary file that can be read",
            std::string{kBoundaryFormats}));
    }
    const std::string driver = dataset->GetDriverName();
    reading.file.isTable = reading.file.isTable || driver == "CSV";
    reading.file.isTrack = reading.file.isTrack || driver == "GPX";
    if (driver == "CSV") {
        const OGRFeatureDefn& definition = *dataset->GetLayer(0)->GetLayerDefn();
        for (int i = 0; i < definition.GetFieldCount(); ++i) {
            reading.file.columns.emplace_back(definition.GetFieldDefn(i)->GetNameRef());
        }
    }
    if (auto checked = checkOpened(source, *dataset); !checked) {
        return checked;
    }
    // What was said while one driver after the other was tried does not matter once one has opened it.
    messages.forget();
    for (OGRLayer* layer : dataset->GetLayers()) {
        if (auto read = readLayer(*layer, source, messages, reading); !read) {
            return read;
        }
    }
    if (driver == "GML" && dataset->GetLayerCount() == 0) {
        return readLoosePolygons(source, reading);
    }
    return {};
}

}  // namespace

Result<VectorFile> readVectorFile(const std::filesystem::path& path,
                                  std::span<const std::string_view> attributes, const JobContext& job) {
    registerGdalDrivers();
    const ThreadOptions options;
    const GdalMessages messages;
    const Result<std::vector<BoundarySource>> sources = boundarySources(path);
    if (!sources) {
        return std::unexpected(sources.error());
    }
    VectorFile file;
    const Reading reading{attributes, job, file};
    for (std::size_t i = 0; i < sources->size(); ++i) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (auto read = readSource((*sources)[i], reading); !read) {
            return std::unexpected(read.error());
        }
        job.report(static_cast<double>(i + 1) / static_cast<double>(sources->size()));
    }
    return file;
}

}  // namespace furrow
