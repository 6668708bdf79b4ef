#include "planner/io/formats/geopackage/geopackage.h"

#include "planner/core/text.h"
#include "planner/io/files/byte_reader.h"
#include "planner/io/files/sqlite.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace furrow {

namespace {

// OGC 12-128r18 (GeoPackage), 2.1.3: a header, then well-known binary; here always little-endian and flat.
enum WkbKind : std::uint32_t { kPoint = 1, kLine = 2, kPolygon = 3, kMultiPolygon = 6 };

struct Geometry {
    std::vector<GeoPolygon> polygons;
    GeoRing line;
    bool good = false;
};

class Wkb {
public:
    explicit Wkb(std::string_view blob) : reader_{blob} {
        good_ = reader_.take(2) == "GP";
        reader_.skip(1);
        const auto flags = reader_.integer<std::uint8_t>();
        reader_.skip(4);
        constexpr std::size_t kEnvelopeBytes[] = {0, 32, 48, 48, 64, 0, 0, 0};
        reader_.skip(kEnvelopeBytes[(flags >> 1U) & 7U]);
    }

    Geometry read() {
        Geometry geometry;
        const std::uint32_t kind = head();
        if (kind == kPoint) {
            geometry.line = {point()};
        } else if (kind == kLine) {
            geometry.line = points();
        } else if (kind == kPolygon) {
            geometry.polygons.push_back(polygon());
        } else if (kind == kMultiPolygon) {
            for (std::uint32_t i = reader_.integer<std::uint32_t>(); i > 0 && reader_.ok(); --i) {
                good_ = head() == kPolygon && good_;
                geometry.polygons.push_back(polygon());
            }
        } else {
            good_ = false;
        }
        geometry.good = good_ && reader_.ok() && reader_.bytesLeft() == 0;
        return geometry;
    }

private:
    std::uint32_t head() {
        good_ = reader_.integer<std::uint8_t>() == 1 && good_;
        return reader_.integer<std::uint32_t>();
    }
    GeoPoint point() {
        const double x = reader_.real();
        return {x, reader_.real()};
    }
    GeoRing points() {
        GeoRing read;
        const auto count = reader_.integer<std::uint32_t>();
        for (std::uint32_t i = 0; i < count && reader_.bytesLeft() >= 16; ++i) {
            read.push_back(point());
        }
        good_ = read.size() == count && good_;
        return read;
    }
    GeoPolygon polygon() {
        GeoPolygon read;
        const auto rings = reader_.integer<std::uint32_t>();
        for (std::uint32_t i = 0; i < rings && reader_.ok() && good_; ++i) {
            (i == 0 ? read.outer : read.holes.emplace_back()) = points();
        }
        return read;
    }

    ByteReader reader_;
    bool good_ = true;
};

class LayerContent {
public:
    LayerContent(sqlite3* database, std::string table, ReceivedContent& found)
        : table_{std::move(table)},
          found_{found},
          rows_{prepared(database, ("SELECT * FROM \"" + table_ + "\"").c_str())} {}

    void take(const std::string& geometryColumn) {
        ReceivedNumbers order;
        ReceivedPath path;
        const int geometryAt = columnOf(geometryColumn.c_str());
        while (rows_ && geometryAt >= 0 && sqlite3_step(rows_.get()) == SQLITE_ROW) {
            const std::string_view blob = bytesAt(rows_.get(), geometryAt);
            Geometry geometry = blob.empty() ? Geometry{} : Wkb{blob}.read();
            if (!geometry.good) {
                found_.faults.push_back(cannotBeRead());
                return;
            }
            if (const auto number = decimalIn(value("order"))) {
                order.numbers.push_back(static_cast<std::int64_t>(*number));
            }
            if (table_ == "path") {
                for (const GeoPoint& point : geometry.line) {
                    path.samples.push_back({.geo = point});
                }
            } else {
                add(std::move(geometry));
            }
        }
        found_.orders.push_back(std::move(order));
        if (!path.samples.empty()) {
            found_.paths.push_back(std::move(path));
        }
    }

private:
    int columnOf(const char* name) const {
        for (int i = 0; rows_ && i < sqlite3_column_count(rows_.get()); ++i) {
            if (std::string_view{sqlite3_column_name(rows_.get(), i)} == name) {
                return i;
            }
        }
        return -1;
    }
    std::string value(const char* name) const {
        const int at = columnOf(name);
        return at < 0 ? std::string{} : std::string{textAt(rows_.get(), at)};
    }

    void add(Geometry&& geometry) {
        const std::string name = value("name").empty() ? table_ : value("name");
        const bool single = geometry.polygons.size() == 1;
        for (GeoPolygon& polygon : geometry.polygons) {
            found_.areas.push_back({.kind = table_ == "boundary"    ? ReceivedArea::Kind::Field
                                            : table_ == "obstacles" ? ReceivedArea::Kind::Obstacle
                                                                    : ReceivedArea::Kind::Other,
                                    .name = name,
                                    .rings = std::move(polygon),
                                    .statedM2 = single ? decimalIn(value("area_m2")) : std::nullopt});
        }
        if (geometry.line.size() == 1) {
            found_.points.push_back(geometry.line.front());
        } else if (!geometry.line.empty()) {
            found_.lines.push_back(
                {.name = name, .points = std::move(geometry.line), .widthM = decimalIn(value("width_m"))});
        }
    }

    std::string table_;
    ReceivedContent& found_;
    SqliteStatement rows_;
};

}  // namespace

std::vector<ReceivedContent> findGeoPackage(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path});
        std::string bytes = file.bytes;
        const SqliteDatabase database = databaseIn(bytes);
        const SqliteStatement layers = prepared(
            database.get(), "SELECT table_name, column_name, srs_id, z, m FROM gpkg_geometry_columns");
        if (!layers) {
            found.faults.push_back(isNot("GeoPackage"));
            continue;
        }
        found.namesCrs = true;
        while (sqlite3_step(layers.get()) == SQLITE_ROW) {
            constexpr int kWgs84 = 4326;
            found.namesCrs = *found.namesCrs && sqlite3_column_int(layers.get(), 2) == kWgs84;
            const std::string column{textAt(layers.get(), 1)};
            LayerContent{database.get(), std::string{textAt(layers.get(), 0)}, found}.take(column);
        }
    }
    return all;
}

}  // namespace furrow
