#include "planner/io/boundary_import.h"

#include "planner/io/file_error.h"
#include "planner/io/gdal_bridge.h"
#include "planner/io/geo_ring.h"
#include "planner/settings/settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <format>
#include <limits>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kFieldsListed = 20;

// The names that files use for these, in order of preference; capitals do not matter.
constexpr std::string_view kIdNames[] = {"id", "field_id", "fieldid", "parcel_id", "localid", "gml_id"};
constexpr std::string_view kNameNames[] = {"field_name", "fieldname", "name", "field"};
constexpr std::string_view kLongitudeNames[] = {"lon", "lng", "long", "longitude", "lon_deg", "x"};
constexpr std::string_view kLatitudeNames[] = {"lat", "latitude", "lat_deg", "y"};
constexpr std::string_view kWktNames[] = {"wkt", "geom", "geometry", "the_geom", "polygon", "boundary"};
constexpr std::string_view kOtherNames[] = {"kind", "passable", "buffer_m", "width_m", "boundary_accuracy_m",
                                            "part", "ring"};

// Of a written plan's features; a file of others may use the attribute for something else.
constexpr std::string_view kKinds[] = {"field",         "obstacle", "gate", "headland", "mainland", "cell",
                                       "headland_pass", "swath",    "path", "missed",   "finding"};

std::span<const std::string_view> attributeNames() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const std::span<const std::string_view> some :
             {std::span<const std::string_view>{kIdNames}, std::span<const std::string_view>{kNameNames},
              std::span<const std::string_view>{kLongitudeNames},
              std::span<const std::string_view>{kLatitudeNames}, std::span<const std::string_view>{kWktNames},
              std::span<const std::string_view>{kOtherNames}}) {
            all.insert(all.end(), some.begin(), some.end());
        }
        return all;
    }();
    return names;
}

const std::string& attribute(const VectorFeature& feature, std::string_view name) {
    const auto names = attributeNames();
    return feature.attributes[static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())];
}

/// The first of these attributes that is there; empty where none is.
std::string firstAttribute(const VectorFeature& feature, std::span<const std::string_view> names) {
    for (const std::string_view name : names) {
        if (const std::string& value = attribute(feature, name); !value.empty()) {
            return value;
        }
    }
    return {};
}

std::string idOf(const VectorFeature& feature) {
    const std::string given = firstAttribute(feature, kIdNames);
    return given.empty() ? feature.key : given;
}

/// A number in either way of writing; nothing where the text is something else.
std::optional<double> numberIn(std::string text) {
    std::ranges::replace(text, ',', '.');
    const std::size_t first = text.find_first_not_of(" \t+");
    const std::size_t last = text.find_last_not_of(" \t");
    if (first == std::string::npos) {
        return std::nullopt;
    }
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data() + first, text.data() + last + 1, number);
    return error == std::errc{} && end == text.data() + last + 1 ? std::optional{number} : std::nullopt;
}

Error usage(std::string what, std::string remedy) {
    return {.code = ErrorCode::Usage, .what = std::move(what), .where = "field", .remedy = std::move(remedy)};
}

/// A length attribute of an obstacle or gate, 0 where there is none.
Result<Length> lengthIn(const VectorFeature& feature, std::string_view name, const std::string& where) {
    const std::string& text = attribute(feature, name);
    if (text.empty()) {
        return metres(0.0);
    }
    const std::optional<double> number = numberIn(text);
    if (!number || !std::isfinite(*number) || *number < 0.0) {
        return std::unexpected(inputRefused(std::format("{}, {}", where, name),
                                            std::format("'{}' is no length", text),
                                            "give metres, 0 or more"));
    }
    return metres(*number);
}

// --- Tables -----------------------------------------------------------------------------------------

/// Rings from a table with a point in each row: rows of one id and part follow each other, and where the
/// ring changes within them a hole begins.
Result<std::vector<VectorFeature>> fieldsFromRows(const std::vector<VectorFeature>& rows,
                                                  const std::string& file) {
    // A column that changes with every row numbers the points; it does not tell fields apart.
    bool idsGroup = false;
    for (std::size_t i = 1; i < rows.size() && !idsGroup; ++i) {
        idsGroup = idOf(rows[i]) == idOf(rows[i - 1]);
    }
    std::vector<VectorFeature> fields;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const VectorFeature& row = rows[i];
        const std::string lonText = firstAttribute(row, kLongitudeNames);
        const std::string latText = firstAttribute(row, kLatitudeNames);
        const std::string where = std::format("{}, row {}", file, i + 1);
        const std::optional<double> lon = numberIn(lonText);
        const std::optional<double> lat = numberIn(latText);
        if (!lon || !lat) {
            return std::unexpected(
                inputRefused(where, std::format("'{}', '{}' is no longitude and latitude", lonText, latText),
                             "give both in degrees, or remove the row"));
        }
        if (std::isfinite(*lon) && std::isfinite(*lat) && (std::abs(*lon) > 180.0 || std::abs(*lat) > 90.0)) {
            return std::unexpected(
                inputRefused(where, std::format("{:.3f}, {:.3f} is no longitude and latitude", *lon, *lat),
                             "give the points in degrees (WGS84), longitude in lon and latitude in lat"));
        }
        const bool sameField = i > 0 && (!idsGroup || idOf(row) == idOf(rows[i - 1]));
        if (!sameField) {
            fields.push_back(row);
            fields.back().points.clear();
            if (!idsGroup) {
                // The first point's number is not the field's id.
                std::ranges::fill(fields.back().attributes, std::string{});
            }
        }
        VectorFeature& field = fields.back();
        const bool samePart = sameField && attribute(row, "part") == attribute(rows[i - 1], "part");
        if (!samePart) {
            field.polygons.emplace_back();
        } else if (attribute(row, "ring") != attribute(rows[i - 1], "ring")) {
            field.polygons.back().holes.emplace_back();
        }
        GeoPolygon& polygon = field.polygons.back();
        GeoRing& ring = polygon.holes.empty() ? polygon.outer : polygon.holes.back();
        ring.push_back({*lon, *lat});
    }
    for (VectorFeature& field : fields) {
        for (GeoPolygon& polygon : field.polygons) {
            const auto open = [](GeoRing& ring) {
                if (ring.size() > 1 && ring.front() == ring.back()) {
                    ring.pop_back();
                }
            };
            open(polygon.outer);
            std::ranges::for_each(polygon.holes, open);
        }
    }
    return fields;
}

Result<void> readTable(VectorFile& file, const std::string& name) {
    const bool hasGeometry = std::ranges::any_of(file.features, &VectorFeature::hasGeometry);
    if (hasGeometry) {
        for (std::size_t i = 0; i < file.features.size(); ++i) {
            const std::string wkt = firstAttribute(file.features[i], kWktNames);
            if (!file.features[i].hasGeometry() && !wkt.empty()) {
                return std::unexpected(
                    inputRefused(std::format("{}, row {}", name, i + 1),
                                 std::format("'{}' is not well-known text", wkt.substr(0, 40)),
                                 "write POLYGON((lon lat, lon lat, ...))"));
            }
        }
        return {};
    }
    const bool hasPoints = std::ranges::any_of(file.features, [](const VectorFeature& row) {
        return !firstAttribute(row, kLongitudeNames).empty() && !firstAttribute(row, kLatitudeNames).empty();
    });
    if (!hasPoints) {
        return std::unexpected(inputRefused(name,
                                            "the table has neither a column WKT nor columns lon and lat",
                                            "name the columns in the first row"));
    }
    Result<std::vector<VectorFeature>> fields = fieldsFromRows(file.features, name);
    if (!fields) {
        return std::unexpected(fields.error());
    }
    file.features = *std::move(fields);
    return {};
}

// --- Obstacles and gates ----------------------------------------------------------------------------

bool touches(const FieldSource& field, const GeoPolygon& outline) {
    return std::ranges::any_of(field.parts, [&outline](const GeoPolygon& part) {
        return std::ranges::any_of(outline.outer, [&part](GeoPoint p) { return contains(part.outer, p); }) ||
               std::ranges::any_of(part.outer, [&outline](GeoPoint p) { return contains(outline.outer, p); });
    });
}

/// In degrees of latitude: good enough to tell which of two fields a gate belongs to.
double distanceDeg(const FieldSource& field, GeoPoint point) {
    const double lonScale = std::cos(point.latDeg * std::numbers::pi / 180.0);
    double nearest = std::numeric_limits<double>::infinity();
    const auto visit = [&](const GeoRing& ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const auto relative = [&](GeoPoint p) {
                return std::pair{std::remainder(p.lonDeg - point.lonDeg, 360.0) * lonScale,
                                 p.latDeg - point.latDeg};
            };
            const auto [ax, ay] = relative(ring[j]);
            const auto [bx, by] = relative(ring[i]);
            const double squared = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
            const double along =
                squared > 0.0 ? std::clamp(-(ax * (bx - ax) + ay * (by - ay)) / squared, 0.0, 1.0) : 0.0;
            nearest = std::min(nearest, std::hypot(ax + along * (bx - ax), ay + along * (by - ay)));
        }
    };
    for (const GeoPolygon& part : field.parts) {
        visit(part.outer);
        std::ranges::for_each(part.holes, visit);
    }
    return nearest;
}

/// What is said of rings that a file left open; they are closed as they are read.
std::optional<Note> noteOfOpenRings(const VectorFeature& feature, std::string where) {
    const std::size_t count = feature.openRings.size();
    if (count == 0) {
        return std::nullopt;
    }
    return Note{.text = count == 1
                            ? std::string{"1 ring did not end where it began and was closed"}
                            : std::format("{} rings did not end where they began and were closed", count),
                .where = std::move(where),
                .place = feature.openRings.front()};
}

Result<void> addObstacle(const VectorFeature& feature, std::vector<FieldSource>& fields,
                         const std::string& file) {
    const std::string name = firstAttribute(feature, kNameNames);
    const std::string where = std::format("{}, obstacle {}", file, name);
    const Result<Length> buffer = lengthIn(feature, "buffer_m", where);
    if (!buffer) {
        return std::unexpected(buffer.error());
    }
    const std::string& passable = attribute(feature, "passable");
    std::optional<Note> note =
        noteOfOpenRings(feature, name.empty() ? "an obstacle" : std::format("obstacle '{}'", name));
    for (const GeoPolygon& outline : feature.polygons) {
        auto owner =
            std::ranges::find_if(fields, [&](const FieldSource& field) { return touches(field, outline); });
        if (owner == fields.end() && fields.size() > 1) {
            return std::unexpected(
                inputRefused(where, std::format("it lies in none of the {} fields", fields.size()),
                             "remove it from the file, or add its field"));
        }
        if (owner == fields.end()) {
            owner = fields.begin();  // where the check of the field says what is wrong with it
        }
        owner->obstacles.push_back({.name = name,
                                    .outline = outline,
                                    .passable = passable == "1" || passable == "true" || passable == "yes",
                                    .buffer = *buffer});
        if (note) {
            owner->repairs.push_back(*std::exchange(note, std::nullopt));
        }
    }
    return {};
}

Result<void> addGate(const VectorFeature& feature, std::vector<FieldSource>& fields,
                     const std::string& file) {
    const std::string name = firstAttribute(feature, kNameNames);
    const Result<Length> width = lengthIn(feature, "width_m", std::format("{}, gate {}", file, name));
    if (!width) {
        return std::unexpected(width.error());
    }
    for (const GeoPoint& position : feature.points) {
        const auto owner = std::ranges::min_element(
            fields, {}, [position](const FieldSource& field) { return distanceDeg(field, position); });
        owner->gates.push_back({.name = name, .position = position, .width = *width});
    }
    return {};
}

// --- Fields -----------------------------------------------------------------------------------------

Result<FieldSource> fieldFrom(VectorFeature& feature, const std::string& file) {
    FieldSource field;
    field.id = idOf(feature);
    field.name = firstAttribute(feature, kNameNames);
    const Result<Length> accuracy = lengthIn(feature, "boundary_accuracy_m", file);
    if (!accuracy) {
        return std::unexpected(accuracy.error());
    }
    field.boundaryAccuracy = *accuracy;
    if (auto note = noteOfOpenRings(feature, "the boundary")) {
        field.repairs.push_back(*std::move(note));
    }
    field.parts = std::move(feature.polygons);
    return field;
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return std::format("{} {}", count, count == 1 ? one : many);
}

Error noPolygon(const VectorFile& file, const std::string& name) {
    std::size_t points = 0;
    std::size_t lines = 0;
    for (const VectorFeature& feature : file.features) {
        points += feature.points.size();
        lines += feature.openLines;
    }
    std::string found;
    if (points > 0) {
        found += counted(points, "point", "points");
    }
    if (lines > 0) {
        found += (found.empty() ? "" : " and ") + counted(lines, "open line", "open lines");
    }
    if (found.empty() && !file.features.empty()) {
        found = counted(file.features.size(), "entry without a shape", "entries without a shape");
    }
    return inputRefused(name, "there is no field boundary in it" + (found.empty() ? "" : ", only " + found),
                        "export the boundary as a polygon");
}

std::string described(const FieldSource& field, std::size_t number) {
    std::string text = std::format("{}", number);
    if (field.id != text) {
        text += " " + field.id;
    }
    if (!field.name.empty() && field.name != field.id) {
        text += std::format(" '{}'", field.name);
    }
    return std::format("{} ({:.2f} ha)", text, inHectares(areaOf(field)));
}

std::string listed(std::span<const FieldSource> fields) {
    std::string text;
    for (std::size_t i = 0; i < std::min(fields.size(), kFieldsListed); ++i) {
        text += (i == 0 ? "" : ", ") + described(fields[i], i + 1);
    }
    if (fields.size() > kFieldsListed) {
        text += std::format(" and {} more", fields.size() - kFieldsListed);
    }
    return text;
}

}  // namespace

Result<std::vector<FieldSource>> readBoundaries(const std::filesystem::path& path, const JobContext& job) {
    Result<VectorFile> file = readVectorFile(path, attributeNames(), job);
    if (!file) {
        return std::unexpected(file.error());
    }
    const std::string name = path.filename().string();
    if (file->isTable) {
        if (auto read = readTable(*file, name); !read) {
            return std::unexpected(read.error());
        }
    }
    const bool isPlan = std::ranges::any_of(
        file->features, [](const VectorFeature& feature) { return attribute(feature, "kind") == "field"; });
    const auto kindOf = [isPlan](const VectorFeature& feature) -> std::string {
        const std::string& kind = attribute(feature, "kind");
        return isPlan || std::ranges::contains(kKinds, kind) ? kind : std::string{};
    };
    const auto isField = [&](const VectorFeature& feature) {
        const std::string kind = kindOf(feature);
        return kind == "field" || (kind.empty() && !isPlan);
    };
    // A guidance line may be closed, too: lines count only where nothing better is in the file.
    const bool hasPolygon = std::ranges::any_of(file->features, [&](const VectorFeature& feature) {
        return isField(feature) && !feature.polygons.empty();
    });
    std::vector<FieldSource> fields;
    for (VectorFeature& feature : file->features) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (!isField(feature)) {
            continue;
        }
        if (!hasPolygon) {
            for (GeoRing& line : feature.closedLines) {
                feature.polygons.push_back({.outer = std::move(line), .holes = {}});
            }
        }
        if (feature.polygons.empty()) {
            continue;
        }
        Result<FieldSource> field = fieldFrom(feature, name);
        if (!field) {
            return std::unexpected(field.error());
        }
        fields.push_back(*std::move(field));
    }
    if (fields.empty()) {
        return std::unexpected(noPolygon(*file, name));
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
        FieldSource& field = fields[i];
        field.origin = fields.size() == 1 ? name : std::format("{}, feature {}", name, i + 1);
        if (field.id.empty()) {
            field.id = std::to_string(i + 1);
        }
        if (field.name.empty()) {
            field.name = field.id;
        }
    }
    for (const VectorFeature& feature : file->features) {
        Result<void> added;
        if (kindOf(feature) == "obstacle") {
            added = addObstacle(feature, fields, name);
        } else if (kindOf(feature) == "gate") {
            added = addGate(feature, fields, name);
        }
        if (!added) {
            return std::unexpected(added.error());
        }
    }
    return fields;
}

Result<FieldSource> pickField(std::span<const FieldSource> fields, std::optional<std::string_view> fieldId) {
    if (!fieldId) {
        if (fields.size() == 1) {
            return fields.front();
        }
        return std::unexpected(usage(std::format("the file has {} fields: {}", fields.size(), listed(fields)),
                                     "choose one by its number, id or name with --field-id"));
    }
    const std::string_view wanted = *fieldId;
    for (const auto member : {&FieldSource::id, &FieldSource::name}) {
        const auto first = std::ranges::find(fields, wanted, member);
        if (first == fields.end()) {
            continue;
        }
        if (std::ranges::find(first + 1, fields.end(), wanted, member) == fields.end()) {
            return *first;
        }
        std::string numbers;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            if (fields[i].*member == wanted) {
                numbers += std::format("{}{}", numbers.empty() ? "" : ", ", i + 1);
            }
        }
        return std::unexpected(usage(std::format("several fields are called '{}'", wanted),
                                     std::format("choose one by its number in the file: {}", numbers)));
    }
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    if (error == std::errc{} && end == wanted.data() + wanted.size() && number >= 1 &&
        number <= fields.size()) {
        return fields[number - 1];
    }
    std::vector<std::string_view> names;
    for (const FieldSource& field : fields) {
        names.push_back(field.id);
        names.push_back(field.name);
    }
    const std::string nearest = nearestName(wanted, names);
    return std::unexpected(
        usage(std::format("there is no field '{}' in the file", wanted),
              nearest.empty()
                  ? std::format("it has {}: {}", counted(fields.size(), "field", "fields"), listed(fields))
                  : std::format("did you mean '{}'?", nearest)));
}

Area areaOf(const FieldSource& field) {
    Area sum;
    for (const GeoPolygon& part : field.parts) {
        sum += geodesicArea(part);
    }
    return sum;
}

}  // namespace furrow
