#include "planner/io/formats/shapefile/shapefile.h"

#include "planner/core/text.h"
#include "planner/gdal/zip.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/files/byte_reader.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace furrow {

namespace {

// ESRI Shapefile Technical Description (1998)
constexpr std::int32_t kFileCode = 9994;
constexpr std::int32_t kPoint = 1;
constexpr std::int32_t kPolyLine = 3;
constexpr std::int32_t kPolygon = 5;

/// A shape's lines; a point is a line of one.
using ShapeLines = std::vector<GeoRing>;

struct Shapes {
    std::int32_t kind = 0;
    std::vector<ShapeLines> shapes;
    bool good = false;
};

/// Nothing where its parts do not fit together.
std::optional<ShapeLines> shapeIn(ByteReader& record, std::int32_t kind) {
    ShapeLines shape;
    if (kind == kPoint) {
        const double x = record.real();
        shape.push_back({{x, record.real()}});
    }
    if (kind != kPolyLine && kind != kPolygon) {
        return shape;
    }
    record.skip(32);
    const auto parts = static_cast<std::size_t>(std::max(record.integer<std::int32_t>(), 0));
    const auto points = static_cast<std::size_t>(std::max(record.integer<std::int32_t>(), 0));
    if (parts * 4 + points * 16 != record.bytesLeft()) {
        return std::nullopt;
    }
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < parts; ++i) {
        starts.push_back(static_cast<std::size_t>(std::max(record.integer<std::int32_t>(), 0)));
    }
    starts.push_back(points);
    if (!std::ranges::is_sorted(starts)) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < parts; ++i) {
        GeoRing line;
        for (std::size_t point = starts[i]; point < starts[i + 1]; ++point) {
            const double x = record.real();
            line.push_back({x, record.real()});
        }
        shape.push_back(std::move(line));
    }
    return shape;
}

Shapes shapesOf(std::string_view bytes) {
    Shapes read;
    ByteReader head{bytes};
    ByteReader bigHead{bytes, std::endian::big};
    const bool isShapefile = bigHead.integer<std::int32_t>() == kFileCode;
    bigHead.skip(20);
    const auto words = bigHead.integer<std::int32_t>();
    head.skip(32);
    read.kind = head.integer<std::int32_t>();
    if (!isShapefile || !head.ok() ||
        std::size_t{2} * static_cast<std::size_t>(std::max(words, 0)) != bytes.size()) {
        return read;
    }
    std::size_t at = 100;
    while (at + 8 <= bytes.size()) {
        ByteReader header{bytes.substr(at), std::endian::big};
        header.skip(4);
        const auto contentWords = header.integer<std::int32_t>();
        const std::size_t size = std::size_t{2} * static_cast<std::size_t>(std::max(contentWords, 0));
        if (size < 4 || size > bytes.size() - at - 8) {
            return read;
        }
        ByteReader record{bytes.substr(at + 8, size)};
        at += 8 + size;
        if (record.integer<std::int32_t>() != read.kind) {
            return read;
        }
        auto shape = shapeIn(record, read.kind);
        if (!shape || !record.ok()) {
            return read;
        }
        read.shapes.push_back(*std::move(shape));
    }
    read.good = at == bytes.size();
    return read;
}

/// A dBASE III table: column by column, row by row, blanks left out.
struct Table {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;

    std::string value(std::size_t row, std::string_view column) const {
        const auto at = static_cast<std::size_t>(std::ranges::find(columns, column) - columns.begin());
        return row < rows.size() && at < rows[row].size() ? rows[row][at] : std::string{};
    }
};

std::string withoutBlanksAround(std::string_view text) {
    const std::size_t first = text.find_first_not_of(std::string_view{" \0", 2});
    const std::size_t last = text.find_last_not_of(std::string_view{" \0", 2});
    return first == std::string_view::npos ? std::string{}
                                           : std::string{text.substr(first, last - first + 1)};
}

Table tableOf(std::string_view bytes) {
    Table table;
    ByteReader head{bytes};
    head.skip(4);
    const auto rows = head.integer<std::uint32_t>();
    const std::size_t headerSize = head.integer<std::uint16_t>();
    const std::size_t rowSize = head.integer<std::uint16_t>();
    std::vector<std::size_t> widths;
    for (std::size_t at = 32; at + 32 <= std::min(headerSize, bytes.size()) && bytes[at] != '\r'; at += 32) {
        table.columns.emplace_back(bytes.substr(at, bytes.substr(at, 11).find('\0')));
        widths.push_back(static_cast<unsigned char>(bytes[at + 16]));
    }
    for (std::size_t row = 0; row < rows && rowSize > 0 && headerSize + (row + 1) * rowSize <= bytes.size();
         ++row) {
        std::string_view record = bytes.substr(headerSize + row * rowSize + 1, rowSize - 1);
        std::vector<std::string>& cells = table.rows.emplace_back();
        for (const std::size_t width : widths) {
            cells.push_back(withoutBlanksAround(record.substr(0, width)));
            record.remove_prefix(std::min(width, record.size()));
        }
    }
    return table;
}

/// In the plane of longitude and latitude, as programs that know no globe see it.
bool runsLeft(const GeoRing& ring) {
    double doubled = 0.0;
    for (std::size_t i = 1; i < ring.size(); ++i) {
        doubled += (ring[i - 1].lonDeg - ring[0].lonDeg) * (ring[i].latDeg - ring[0].latDeg) -
                   (ring[i].lonDeg - ring[0].lonDeg) * (ring[i - 1].latDeg - ring[0].latDeg);
    }
    return doubled > 0.0;
}

/// The rings of one shape: clockwise ones are outlines, the others holes of the one they lie in.
std::vector<GeoPolygon> polygonsOf(const ShapeLines& shape) {
    std::vector<GeoPolygon> polygons;
    std::vector<const GeoRing*> holes;
    for (const GeoRing& ring : shape) {
        if (polygons.empty() || !runsLeft(ring)) {
            polygons.push_back({.outer = ring, .holes = {}});
        } else {
            holes.push_back(&ring);
        }
    }
    for (const GeoRing* hole : holes) {
        const auto around = std::ranges::find_if(polygons, [hole](const GeoPolygon& polygon) {
            return !hole->empty() && contains(polygon.outer, hole->front());
        });
        (around == polygons.end() ? polygons.front() : *around).holes.push_back(*hole);
    }
    return polygons;
}

void addPolygons(const Shapes& read, const Table& table, const std::string& layer, ReceivedContent& found) {
    for (std::size_t i = 0; i < read.shapes.size(); ++i) {
        const std::string kind = table.value(i, "kind").empty() ? layer : table.value(i, "kind");
        std::vector<GeoPolygon> polygons = polygonsOf(read.shapes[i]);
        std::optional<double> stated = decimalIn(table.value(i, "area_m2"));
        if (const auto hectares = decimalIn(table.value(i, "Area"))) {
            stated = *hectares * 1e4;
        }
        stated = polygons.size() == 1 ? stated : std::nullopt;
        std::string name = table.value(i, "name") + table.value(i, "Name") + table.value(i, "FIELD_NAME");
        for (GeoPolygon& polygon : polygons) {
            found.areas.push_back({.kind = kind == "field" || kind == "boundary" || kind == "Boundary"
                                               ? ReceivedArea::Kind::Field
                                           : kind == "obstacle" ? ReceivedArea::Kind::Obstacle
                                                                : ReceivedArea::Kind::Other,
                                   .name = name.empty() ? layer : name,
                                   .rings = std::move(polygon),
                                   .statedM2 = stated});
        }
    }
}

void addLines(Shapes&& read, const Table& table, const std::string& layer, ReceivedContent& found) {
    ReceivedNumbers order;
    ReceivedPath path;
    ReceivedNames names{.names = {}, .mustDiffer = layer == "Swaths"};
    for (std::size_t i = 0; i < read.shapes.size(); ++i) {
        if (const auto number = decimalIn(table.value(i, "order"))) {
            order.numbers.push_back(static_cast<std::int64_t>(*number));
        }
        for (GeoRing& line : read.shapes[i]) {
            if (layer == "path") {
                for (const GeoPoint& point : line) {
                    path.samples.push_back({.geo = point});
                }
                continue;
            }
            std::string name = table.value(i, "name") + table.value(i, "Name");
            names.names.push_back(name);
            const auto width = decimalIn(table.value(i, "width_m"));
            found.lines.push_back(
                {.name = name.empty() ? layer : std::move(name), .points = std::move(line), .widthM = width});
        }
    }
    found.orders.push_back(std::move(order));
    found.names.push_back(std::move(names));
    if (!path.samples.empty()) {
        found.paths.push_back(std::move(path));
    }
}

}  // namespace

std::vector<ReceivedContent> findShapefiles(std::span<const FileInMemory> files, const ExportJob&) {
    std::map<std::string, std::string_view> byPath;
    for (const FileInMemory& file : files) {
        byPath[file.path] = file.bytes;
    }
    std::vector<ReceivedContent> all;
    for (const auto& [path, bytes] : byPath) {
        if (!path.ends_with(".shp")) {
            continue;
        }
        ReceivedContent& found = all.emplace_back(ReceivedContent{
            .file = path, .winding = ReceivedContent::Winding::OuterRight, .namesCrs = false});
        const std::string stem = path.substr(0, path.size() - 4);
        for (const char* companion : {".shx", ".dbf"}) {
            if (!byPath.contains(stem + companion)) {
                found.faults.push_back(isMissing(stem + companion));
            }
        }
        const auto projection = byPath.find(stem + ".prj");
        found.namesCrs = projection != byPath.end() && projection->second.contains("WGS");
        Shapes read = shapesOf(bytes);
        const std::string layer = stem.substr(stem.rfind('/') + 1);
        const auto dbf = byPath.find(stem + ".dbf");
        const Table table = dbf == byPath.end() ? Table{} : tableOf(dbf->second);
        if (!read.good) {
            found.faults.push_back(cannotBeRead());
        } else if (dbf != byPath.end() && table.rows.size() != read.shapes.size()) {
            found.faults.push_back(badCount(read.shapes.size(), table.rows.size()));
        }
        if (read.kind == kPolygon) {
            addPolygons(read, table, layer, found);
        } else if (read.kind == kPolyLine) {
            addLines(std::move(read), table, layer, found);
        } else if (read.kind == kPoint) {
            for (const ShapeLines& shape : read.shapes) {
                found.points.push_back(shape.front().front());
            }
        } else if (read.good) {
            found.faults.emplace_back("its shapes have heights or measures, which displays do not read");
        }
    }
    if (all.empty()) {
        all.push_back({.file = ".shp"});
        all.back().faults.push_back(isMissing(".shp"));
    }
    return all;
}

std::vector<ReceivedContent> findZippedShapefile(std::span<const FileInMemory> files, const ExportJob& job) {
    std::vector<FileInMemory> inside;
    for (const FileInMemory& file : files) {
        std::ranges::move(filesInZip(file.bytes), std::back_inserter(inside));
    }
    return findShapefiles(inside, job);
}

}  // namespace furrow
