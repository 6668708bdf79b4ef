#include "planner/io/content/export_job.h"
#include "planner/io/content/received_content.h"
#include "planner/io/files/byte_reader.h"

#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace furrow {

namespace {

struct DatabaseCloser {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct StatementCloser {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, StatementCloser>;

Statement prepared(sqlite3* database, const std::string& text) {
    sqlite3_stmt* made = nullptr;
    sqlite3_prepare_v2(database, text.c_str(), -1, &made, nullptr);
    return Statement{made};
}

std::string textAt(sqlite3_stmt* statement, int column) {
    const auto* text = sqlite3_column_text(statement, column);
    return text == nullptr ? std::string{} : std::string{reinterpret_cast<const char*>(text)};
}

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
        geometry.good = good_ && reader_.ok() && reader_.left() == 0;
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
        for (std::uint32_t i = 0; i < count && reader_.left() >= 16; ++i) {
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
    LayerContent(sqlite3* database, std::string table, FoundContent& found)
        : table_{std::move(table)}, found_{found}, rows_{prepared(database, "SELECT * FROM \"" + table_ + "\"")} {}

    void take(const std::string& geometryColumn) {
        FoundOrder order;
        FoundPath path;
        const int geometryAt = columnOf(geometryColumn.c_str());
        while (rows_ && geometryAt >= 0 && sqlite3_step(rows_.get()) == SQLITE_ROW) {
            const auto* blob = static_cast<const char*>(sqlite3_column_blob(rows_.get(), geometryAt));
            const auto size = static_cast<std::size_t>(sqlite3_column_bytes(rows_.get(), geometryAt));
            Geometry geometry = blob == nullptr ? Geometry{} : Wkb{{blob, size}}.read();
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
        return at < 0 ? std::string{} : textAt(rows_.get(), at);
    }

    void add(Geometry&& geometry) {
        const std::string name = value("name").empty() ? table_ : value("name");
        const bool single = geometry.polygons.size() == 1;
        for (GeoPolygon& polygon : geometry.polygons) {
            found_.areas.push_back({.kind = table_ == "boundary"    ? FoundArea::Kind::Field
                                            : table_ == "obstacles" ? FoundArea::Kind::Obstacle
                                                                    : FoundArea::Kind::Other,
                                    .name = name,
                                    .rings = std::move(polygon),
                                    .statedM2 = single ? decimalIn(value("area_m2")) : std::nullopt});
        }
        if (geometry.line.size() == 1) {
            found_.points.push_back(geometry.line.front());
        } else if (!geometry.line.empty()) {
            found_.lines.push_back({.name = name, .points = std::move(geometry.line), .widthM = decimalIn(value("width_m"))});
        }
    }

    std::string table_;
    FoundContent& found_;
    Statement rows_;
};

}  // namespace

std::vector<FoundContent> findGeoPackage(std::span<const ExportedFile> files, const ExportJob&) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path});
        sqlite3* opened = nullptr;
        sqlite3_open(":memory:", &opened);
        const std::unique_ptr<sqlite3, DatabaseCloser> database{opened};
        std::string bytes = file.bytes;
        const auto size = static_cast<sqlite3_int64>(bytes.size());
        const bool good = sqlite3_deserialize(opened, "main", reinterpret_cast<unsigned char*>(bytes.data()), size, size,
                                              SQLITE_DESERIALIZE_READONLY) == SQLITE_OK;
        const Statement layers =
            good ? prepared(opened, "SELECT table_name, column_name, srs_id, z, m FROM gpkg_geometry_columns") : Statement{};
        if (!layers) {
            found.faults.push_back(isNot("GeoPackage"));
            continue;
        }
        found.namesCrs = true;
        while (sqlite3_step(layers.get()) == SQLITE_ROW) {
            constexpr int kWgs84 = 4326;
            found.namesCrs = *found.namesCrs && sqlite3_column_int(layers.get(), 2) == kWgs84;
            LayerContent{opened, textAt(layers.get(), 0), found}.take(textAt(layers.get(), 1));
        }
    }
    return all;
}

}  // namespace furrow
