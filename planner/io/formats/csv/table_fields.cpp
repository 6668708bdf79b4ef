#include "planner/io/formats/csv/table_fields.h"

#include "planner/core/file_error.h"
#include "planner/core/text.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/content/vector_attributes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace furrow {

namespace {

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
        const Message where = message("{}, row {}", file, i + 1);
        const std::optional<double> lon = numberIn(lonText, true);
        const std::optional<double> lat = numberIn(latText, true);
        if (!lon || !lat) {
            return std::unexpected(
                inputRefused(where, message("'{}', '{}' is no longitude and latitude", lonText, latText),
                             "give both in degrees, or remove the row"));
        }
        if (std::isfinite(*lon) && std::isfinite(*lat) && (std::abs(*lon) > 180.0 || std::abs(*lat) > 90.0)) {
            return std::unexpected(
                inputRefused(where, message("{:.3f}, {:.3f} is no longitude and latitude", *lon, *lat),
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

// What only machines record, and what loggers do too; letters of a column's name, small.
constexpr std::string_view kWorkColumns[] = {"flow",      "moisture",  "yield",  "yld",      "curvature",
                                             "implement", "workstate", "loadid", "grainflow"};
constexpr std::string_view kLogColumns[] = {"time", "speed", "velocity", "heading", "course", "bearing"};

// A walk round a field comes back to within this share of its length.
constexpr double kRoundTripShare = 0.05;

bool hasColumnOf(const VectorFile& file, std::span<const std::string_view> words) {
    return std::ranges::any_of(file.columns, [words](const std::string& column) {
        std::string letters;
        for (const char letter : inSmallLetters(column)) {
            letters += letter >= 'a' && letter <= 'z' ? std::string(1, letter) : std::string{};
        }
        return std::ranges::any_of(words,
                                   [&letters](std::string_view word) { return letters.starts_with(word); });
    });
}

/// It ends far from where it began.
bool isOneWay(const VectorFeature& field) {
    return std::ranges::any_of(field.polygons, [](const GeoPolygon& polygon) {
        double lengthM = 0.0;
        for (std::size_t i = 1; i < polygon.outer.size(); ++i) {
            lengthM += roughDistanceM(polygon.outer[i - 1], polygon.outer[i]);
        }
        return roughDistanceM(polygon.outer.front(), polygon.outer.back()) > kRoundTripShare * lengthM;
    });
}

Error recordedDrive(const std::string& name) {
    return inputRefused(name, message("this is the recording of a drive ({}), and no boundary", "CSV"),
                        "give the field's boundary; furrow-cli compare lays a recording over a plan");
}

}  // namespace

Result<void> readTable(VectorFile& file, const std::string& name) {
    const bool hasGeometry = std::ranges::any_of(file.features, &VectorFeature::hasGeometry);
    if (hasGeometry) {
        for (std::size_t i = 0; i < file.features.size(); ++i) {
            const std::string wkt = firstAttribute(file.features[i], kWktNames);
            if (!file.features[i].hasGeometry() && !wkt.empty()) {
                return std::unexpected(inputRefused(message("{}, row {}", name, i + 1),
                                                    message("'{}' is not well-known text", wkt.substr(0, 40)),
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
    if (hasColumnOf(file, kWorkColumns)) {
        return std::unexpected(recordedDrive(name));
    }
    Result<std::vector<VectorFeature>> fields = fieldsFromRows(file.features, name);
    if (!fields) {
        return std::unexpected(fields.error());
    }
    // Loggers write what is driven and what is walked round a field alike.
    if (hasColumnOf(file, kLogColumns) && std::ranges::any_of(*fields, isOneWay)) {
        return std::unexpected(recordedDrive(name));
    }
    file.features = *std::move(fields);
    return {};
}

}  // namespace furrow
