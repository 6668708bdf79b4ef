#include "planner/io/gdal_bridge.h"

#include <cpl_conv.h>
#include <cpl_error.h>
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
#include <format>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

namespace furrow {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// Two chords per 2 degrees of arc: 1.5 cm beside the circle of a centre pivot of 400 m radius.
constexpr double kArcStepDeg = 1.0;

// A millimetre on the ground.
constexpr double kSamePointDeg = 1e-8;

// Text larger than this is no boundary that a person made.
constexpr vsi_l_offset kLargestTextBytes = vsi_l_offset{1} << 30;

constexpr std::string_view kFormats =
    "give GeoJSON, a shapefile (.shp or .zip), KML, KMZ, GeoPackage, GML, FlatGeobuf, WKT or CSV";

// Only these: others may follow references to elsewhere (VRT, WFS) or run for ever on the wrong input.
constexpr const char* kDrivers[] = {"GeoJSON",        "GeoJSONSeq",  "JSONFG", "TopoJSON", "ESRIJSON",
                                    "ESRI Shapefile", "LIBKML",      "KML",    "GPKG",     "GML",
                                    "FlatGeobuf",     "OpenFileGDB", "CSV",    "GPX",      nullptr};
constexpr const char* kPlainKml[] = {"KML", nullptr};

void registerDrivers() {
    static std::once_flag once;
    std::call_once(once, [] {
        GDALAllRegister();
        OSRSetPROJEnableNetwork(0);
    });
}

/// Keeps what GDAL would print; the first failure is the one that explains the others.
class Messages {
public:
    Messages() { CPLPushErrorHandlerEx(&Messages::keep, this); }
    ~Messages() { CPLPopErrorHandler(); }
    Messages(const Messages&) = delete;
    Messages& operator=(const Messages&) = delete;

    bool failed() const { return !failure_.empty(); }
    const std::string& failure() const { return failure_; }
    void forget() { failure_.clear(); }

private:
    static void CPL_STDCALL keep(CPLErr severity, CPLErrorNum, const char* message) {
        auto* self = static_cast<Messages*>(CPLGetErrorHandlerUserData());
        if (severity >= CE_Failure && self->failure_.empty()) {
            self->failure_ = message;
        }
    }
    std::string failure_;
};

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
        {"GDAL_HTTP_MAX_RETRY", "0"},
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

std::string smallLetters(std::string_view text) {
    std::string small{text};
    std::ranges::transform(small, small.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return small;
}

std::string extensionOf(std::string_view path) {
    return smallLetters(std::filesystem::path{path}.extension().string());
}

Error readFailed(const std::string& where, std::string what, std::string remedy) {
    return {
        .code = ErrorCode::ReadFailed, .what = std::move(what), .where = where, .remedy = std::move(remedy)};
}

Error refused(const std::string& where, std::string what, std::string remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = where,
            .remedy = std::move(remedy)};
}

/// The text of a file, of its first `limit` bytes; nothing where it cannot be read.
std::optional<std::string> textOf(const std::string& path, vsi_l_offset limit = kLargestTextBytes) {
    VSILFILE* file = VSIFOpenL(path.c_str(), "rb");
    if (file == nullptr) {
        return std::nullopt;
    }
    std::string text;
    constexpr std::size_t kBlock = 1 << 20;
    while (text.size() < limit) {
        const std::size_t before = text.size();
        const std::size_t wanted = static_cast<std::size_t>(std::min<vsi_l_offset>(kBlock, limit - before));
        text.resize(before + wanted);
        const std::size_t got = VSIFReadL(text.data() + before, 1, wanted, file);
        text.resize(before + got);
        if (got < wanted) {
            break;
        }
    }
    VSIFCloseL(file);
    return text;
}

std::string_view withoutMark(std::string_view text) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

std::string_view withoutBlanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

std::string lineAndColumn(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t lineBreak = before.rfind('\n');
    return std::format("line {}, column {}", std::ranges::count(before, '\n') + 1,
                       before.size() - (lineBreak == std::string_view::npos ? 0 : lineBreak + 1) + 1);
}

// --- Geometry ---------------------------------------------------------------------------------------

/// From a layer's coordinates to WGS84.
class ToWgs84 {
public:
    /// Without a coordinate system longitude and latitude are assumed, and checked by `allInRange`.
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
                refused(where,
                        std::format("its coordinate system '{}' cannot be turned into WGS84",
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
            } else if (line.getNumPoints() > 0) {
                ++feature.openLines;
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

/// The first finite point that cannot be a longitude and latitude.
std::optional<GeoPoint> firstOutOfRange(const VectorFeature& feature) {
    const auto outside = [](const GeoPoint& point) {
        return std::isfinite(point.lonDeg) && std::isfinite(point.latDeg) &&
               (std::abs(point.lonDeg) > 180.0 || std::abs(point.latDeg) > 90.0);
    };
    const auto firstOf = [&outside](const GeoRing& ring) -> std::optional<GeoPoint> {
        const auto found = std::ranges::find_if(ring, outside);
        return found == ring.end() ? std::nullopt : std::optional{*found};
    };
    for (const GeoPolygon& polygon : feature.polygons) {
        if (const auto found = firstOf(polygon.outer)) {
            return found;
        }
    }
    for (const GeoRing& ring : feature.closedLines) {
        if (const auto found = firstOf(ring)) {
            return found;
        }
    }
    return firstOf(feature.points);
}

Result<void> checkRange(const VectorFeature& feature, const ToWgs84& toWgs84, const std::string& where) {
    if (toWgs84.known()) {
        return {};
    }
    if (const auto point = firstOutOfRange(feature)) {
        return std::unexpected(
            refused(where,
                    std::format("{:.3f}, {:.3f} is no longitude and latitude, and the file does not say "
                                "which coordinate system it uses",
                                point->lonDeg, point->latDeg),
                    "add the .prj file that belongs to it, or export the field again in WGS84"));
    }
    return {};
}

// --- One source -------------------------------------------------------------------------------------

/// One file to open: loose, or inside a zip.
struct Source {
    std::string path;  ///< as GDAL opens it
    std::string name;  ///< as people know it
};

/// Everything a reader of one source needs.
struct Reading {
    std::span<const std::string_view> attributes;
    const JobContext& job;
    VectorFile& file;
};

/// Follows a GeoJSON text without keeping it, to find what GDAL leaves out without a word: positions with
/// something else than two numbers.
class CoordinateCheck final : public nlohmann::json_sax<nlohmann::json> {
public:
    bool foundBad() const { return bad_; }
    /// "feature 2, part 1, ring 1, vertex 3"; only what there is of it.
    const std::string& place() const { return place_; }
    bool brokeOff() const { return brokeOff_.has_value(); }
    std::size_t brokeOffAt() const { return *brokeOff_; }

    bool null() override { return scalar(false); }
    bool boolean(bool) override { return scalar(false); }
    bool number_integer(number_integer_t) override { return scalar(true); }
    bool number_unsigned(number_unsigned_t) override { return scalar(true); }
    bool number_float(number_float_t, const string_t&) override { return scalar(true); }
    bool string(string_t&) override { return scalar(false); }
    bool binary(binary_t&) override { return scalar(false); }

    bool start_object(std::size_t) override {
        if (!levels_.empty()) {
            return scalar(false);
        }
        ++depth_;
        if (key_ == "properties" && propertiesDepth_ == 0) {
            propertiesDepth_ = depth_;
        }
        if (depth_ == featuresDepth_ + 1 && featuresDepth_ > 0) {
            ++feature_;
        }
        key_.clear();
        return true;
    }
    bool end_object() override {
        if (propertiesDepth_ == depth_) {
            propertiesDepth_ = 0;
        }
        --depth_;
        return true;
    }
    bool key(string_t& name) override {
        key_ = name;
        return true;
    }
    bool start_array(std::size_t) override {
        ++depth_;
        if (!levels_.empty()) {
            ++levels_.back().members;
            levels_.back().hasArrays = true;
            levels_.emplace_back();
        } else if (key_ == "coordinates" && propertiesDepth_ == 0) {
            levels_.emplace_back();
        } else if (key_ == "features" && featuresDepth_ == 0 && propertiesDepth_ == 0) {
            featuresDepth_ = depth_;
        }
        key_.clear();
        return true;
    }
    bool end_array() override {
        --depth_;
        if (!levels_.empty()) {
            const Level closed = levels_.back();
            // An empty array stands for an empty geometry, which is allowed.
            if (closed.members == 1 && !closed.hasArrays) {
                return bad();
            }
            levels_.pop_back();
        }
        return true;
    }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
        brokeOff_ = position > 0 ? position - 1 : 0;
        return false;
    }

private:
    struct Level {
        std::size_t members = 0;
        bool hasArrays = false;
    };

    bool scalar(bool isNumber) {
        key_.clear();
        if (levels_.empty()) {
            return true;
        }
        if (!isNumber || levels_.back().hasArrays) {
            return bad();
        }
        ++levels_.back().members;
        return true;
    }

    bool bad() {
        bad_ = true;
        if (feature_ > 0) {
            place_ = std::format("feature {}", feature_);
        }
        // Among positions a member that is none counts itself; inside one the arrays around it count.
        if (levels_.back().hasArrays) {
            ++levels_.back().members;
        } else {
            levels_.pop_back();
        }
        constexpr std::string_view kNames[] = {"vertex", "ring", "part"};
        const std::size_t first = levels_.size() > 3 ? levels_.size() - 3 : 0;
        for (std::size_t i = first; i < levels_.size(); ++i) {
            place_ += std::format("{}{} {}", place_.empty() ? "" : ", ", kNames[levels_.size() - 1 - i],
                                  levels_[i].members);
        }
        return false;
    }

    std::string key_;
    std::size_t depth_ = 0;
    std::size_t propertiesDepth_ = 0;
    std::size_t featuresDepth_ = 0;
    std::size_t feature_ = 0;
    std::vector<Level> levels_;  ///< the arrays of "coordinates" around the current place
    bool bad_ = false;
    std::string place_;
    std::optional<std::size_t> brokeOff_;
};

/// Refuses a GeoJSON text with a coordinate that is no number. NaN and Infinity, which JSON does not know
/// but GDAL reads, are left to the check of the field, which names their place.
///
/// @param opened  GDAL could read the text; where it could not, and it is no JSON, the place is told
Result<void> checkGeoJson(const Source& source, bool opened) {
    const std::optional<std::string> text = textOf(source.path);
    if (!text) {
        return {};
    }
    CoordinateCheck check;
    nlohmann::json::sax_parse(*text, &check);
    if (check.foundBad()) {
        return std::unexpected(
            refused(check.place().empty() ? source.name : std::format("{}, {}", source.name, check.place()),
                    "a coordinate is not a number", "give each point as [longitude, latitude]"));
    }
    if (!opened && check.brokeOff()) {
        return std::unexpected(readFailed(
            std::format("{}, {}", source.name, lineAndColumn(*text, check.brokeOffAt())),
            "this is not JSON from here on", "the file may be cut off or damaged; export it again"));
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
Dataset openDataset(const std::string& path, Messages& messages) {
    Dataset dataset = openWith(path, kDrivers);
    if (extensionOf(path) == ".kml" && (!dataset || dataset->GetLayerCount() == 0)) {
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

Result<void> readLayer(OGRLayer& layer, const Source& source, const Messages& messages,
                       const Reading& reading) {
    const Result<ToWgs84> toWgs84 = ToWgs84::from(layer.GetSpatialRef(), source.name);
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
        if (auto inRange = checkRange(feature, *toWgs84, source.name); !inRange) {
            return inRange;
        }
        reading.file.features.push_back(std::move(feature));
    }
    if (messages.failed()) {
        return std::unexpected(readFailed(source.name,
                                          std::format("the file is damaged ({})", messages.failure()),
                                          "export or copy it again"));
    }
    return {};
}

bool looksLikeWkt(std::string_view start) {
    const std::string small = smallLetters(withoutBlanks(withoutMark(start)).substr(0, 32));
    constexpr std::string_view kWords[] = {"polygon",      "multipolygon",       "curvepolygon",
                                           "multisurface", "geometrycollection", "srid="};
    return std::ranges::any_of(kWords, [&small](std::string_view word) { return small.starts_with(word); });
}

/// One or more geometries in well-known text, one after the other; "SRID=25832;" before one is understood.
Result<void> readWkt(const Source& source, const Reading& reading) {
    const std::optional<std::string> text = textOf(source.path);
    if (!text) {
        return std::unexpected(
            readFailed(source.name, "the file cannot be read", "check that you may read it"));
    }
    std::size_t at = text->size() - withoutMark(*text).size();
    while (true) {
        at = text->find_first_not_of(" \t\r\n;,\"", at);
        if (at == std::string::npos) {
            return {};
        }
        if (reading.job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const std::string place = std::format("{}, {}", source.name, lineAndColumn(*text, at));
        OGRSpatialReference system;
        if (smallLetters(std::string_view{*text}.substr(at, 5)) == "srid=") {
            int code = 0;
            const char* end = text->data() + text->size();
            const auto [next, error] = std::from_chars(text->data() + at + 5, end, code);
            if (error != std::errc{} || next == end || *next != ';' ||
                (code != 0 && system.importFromEPSG(code) != OGRERR_NONE)) {
                return std::unexpected(refused(place,
                                               "the number after SRID= is no coordinate system that is known",
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
            return std::unexpected(refused(place, "this is not well-known text from here on",
                                           "write POLYGON((lon lat, lon lat, ...)), one polygon a line"));
        }
        const Result<ToWgs84> toWgs84 = ToWgs84::from(&system, source.name);
        if (!toWgs84) {
            return std::unexpected(toWgs84.error());
        }
        VectorFeature feature;
        feature.attributes.resize(reading.attributes.size());
        addGeometry(*geometry, *toWgs84, feature);
        if (auto inRange = checkRange(feature, *toWgs84, place); !inRange) {
            return inRange;
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
Result<void> readLoosePolygons(const Source& source, const Reading& reading) {
    const std::optional<std::string> text = textOf(source.path);
    pugi::xml_document document;
    if (!text) {
        return std::unexpected(
            readFailed(source.name, "the file cannot be read", "check that you may read it"));
    }
    if (const pugi::xml_parse_result parsed = document.load_buffer(text->data(), text->size()); !parsed) {
        return std::unexpected(readFailed(
            std::format("{}, {}", source.name, lineAndColumn(*text, static_cast<std::size_t>(parsed.offset))),
            "this is not XML from here on", "the file may be cut off or damaged; export it again"));
    }
    const auto nameColumn = std::ranges::find(reading.attributes, "name") - reading.attributes.begin();
    for (const pugi::xpath_node& found : document.select_nodes("//*[local-name()='Polygon']")) {
        std::ostringstream gml;
        found.node().print(gml, "", pugi::format_raw);
        const std::unique_ptr<OGRGeometry> geometry{OGRGeometryFactory::createFromGML(gml.str().c_str())};
        if (!geometry) {
            return std::unexpected(refused(
                std::format("{}, {}", source.name,
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
        if (auto inRange = checkRange(feature, *toWgs84, source.name); !inRange) {
            return inRange;
        }
        reading.file.features.push_back(std::move(feature));
    }
    return {};
}

Result<void> readSource(const Source& source, const Reading& reading) {
    Messages messages;
    const std::string start = textOf(source.path, 4096).value_or("");
    const std::string extension = extensionOf(source.path);
    if (extension == ".wkt" || looksLikeWkt(start)) {
        return readWkt(source, reading);
    }
    messages.forget();
    const Dataset dataset = openDataset(source.path, messages);
    if (!dataset) {
        if (withoutBlanks(withoutMark(start)).starts_with('{')) {
            if (auto checked = checkGeoJson(source, false); !checked) {
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
            messages.failed() ? std::format("no boundary can be read from this file ({})", messages.failure())
                              : "this is no boundary file that can be read",
            std::string{kFormats}));
    }
    const std::string driver = dataset->GetDriverName();
    reading.file.isTable = reading.file.isTable || driver == "CSV";
    if (driver == "GeoJSON") {
        if (auto checked = checkGeoJson(source, true); !checked) {
            return checked;
        }
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

// --- Which sources ----------------------------------------------------------------------------------

bool isZip(const std::string& path) {
    return textOf(path, 4).value_or("").starts_with("PK\x03\x04");
}

/// What can be read inside a zip. Files that often only describe the others (.json, .xml, .csv) count
/// where there is nothing else.
std::vector<Source> sourcesInZip(const std::string& path, const std::string& name) {
    // Braces keep a name with blanks, brackets or another ".zip" in it in one piece.
    const std::string root = std::format("/vsizip/{{{}}}", path);
    const CPLStringList entries{VSIReadDirRecursive(root.c_str())};
    std::set<std::string> sure;
    std::set<std::string> perhaps;
    constexpr std::string_view kSure[] = {".shp", ".gpkg", ".gml", ".geojson",
                                          ".kml", ".fgb",  ".wkt", ".gpx"};
    constexpr std::string_view kPerhaps[] = {".json", ".xml", ".csv"};
    for (int i = 0; i < entries.size(); ++i) {
        const std::filesystem::path entry{entries[i]};
        const std::string fileName = entry.filename().string();
        if (std::string_view{entries[i]}.starts_with("__MACOSX") || fileName.starts_with("._")) {
            continue;
        }
        if (const std::size_t end = smallLetters(entries[i]).find(".gdb/"); end != std::string::npos) {
            sure.insert(std::string{entries[i]}.substr(0, end + 4));
            continue;
        }
        const std::string extension = extensionOf(fileName);
        if (extension == ".gdbtable") {
            return {
                {path, name}};  // a geodatabase zipped without its folder: its driver takes the zip itself
        }
        if (std::ranges::contains(kSure, extension)) {
            sure.insert(entries[i]);
        } else if (std::ranges::contains(kPerhaps, extension)) {
            perhaps.insert(entries[i]);
        }
    }
    std::vector<Source> sources;
    for (const std::string& entry : sure.empty() ? perhaps : sure) {
        sources.push_back({root + "/" + entry, std::format("{}, {}", name, entry)});
    }
    return sources;
}

/// Of a shapefile people may choose any of its files.
std::filesystem::path mainFileOf(const std::filesystem::path& path) {
    constexpr std::string_view kCompanions[] = {".shx", ".dbf", ".prj", ".cpg"};
    if (std::ranges::contains(kCompanions, extensionOf(path.string()))) {
        for (const char* extension : {".shp", ".SHP"}) {
            std::filesystem::path shapes = path;
            shapes.replace_extension(extension);
            if (std::filesystem::exists(shapes)) {
                return shapes;
            }
        }
    }
    return path;
}

Result<std::vector<Source>> sourcesOf(const std::filesystem::path& given) {
    const std::string name = given.filename().string();
    const std::string text = given.string();
    if (text.find("://") != std::string::npos || text.starts_with("/vsi")) {
        return std::unexpected(
            readFailed(text, "only files on this computer are read", "download the file and give its path"));
    }
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(given, error);
    if (!std::filesystem::exists(status)) {
        return std::unexpected(readFailed(text, "there is no such file", "check the path"));
    }
    // Absolute, so that no part of the name can be taken for a prefix of GDAL's.
    const std::filesystem::path path = mainFileOf(std::filesystem::absolute(given));
    if (std::filesystem::is_directory(status)) {
        if (extensionOf(name) == ".gdb") {
            return std::vector<Source>{{path.string(), name}};
        }
        return std::unexpected(readFailed(text, "this is a folder", "give one of the files in it"));
    }
    if (!std::filesystem::is_regular_file(status)) {
        return std::unexpected(readFailed(text, "this is no ordinary file", "give a file on a disk"));
    }
    if (std::filesystem::file_size(path, error) == 0 && !error) {
        return std::unexpected(refused(text, "the file is empty", "export the field again"));
    }
    if (!textOf(path.string(), 1)) {
        return std::unexpected(readFailed(text, "the file cannot be read", "check that you may read it"));
    }
    if (!isZip(path.string())) {
        return std::vector<Source>{{path.string(), name}};
    }
    std::vector<Source> sources = sourcesInZip(path.string(), name);
    if (sources.empty()) {
        return std::unexpected(
            readFailed(text, "there is no boundary file in this zip", std::string{kFormats}));
    }
    return sources;
}

}  // namespace

Result<VectorFile> readVectorFile(const std::filesystem::path& path,
                                  std::span<const std::string_view> attributes, const JobContext& job) {
    registerDrivers();
    const ThreadOptions options;
    const Messages messages;
    const Result<std::vector<Source>> sources = sourcesOf(path);
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
