#include "planner/io/formats/vector/vector_file.h"

#include "planner/core/file_error.h"
#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/core/text_file.h"
#include "planner/gdal/drivers.h"
#include "planner/gdal/loose_shapes.h"
#include "planner/gdal/messages.h"
#include "planner/gdal/system_files.h"
#include "planner/gdal/vector_dataset.h"
#include "planner/io/files/sqlite.h"
#include "planner/io/formats/geojson/geojson_check.h"
#include "planner/io/formats/geojson/geojson_crs.h"
#include "planner/io/formats/vector/vector_source.h"

#include <sqlite3.h>

#include <algorithm>
#include <ranges>
#include <string>
#include <vector>

namespace furrow {

namespace {

constexpr std::string_view kSqliteMagic = "SQLite format 3";
constexpr std::string_view kBinaryDrawing = "AutoCAD Binary DXF";
constexpr std::string_view kDrawingComment = "999";

// The tables of a GeoPackage and of its drivers.
constexpr std::string_view kOwnNames[] = {"gpkg_", "ogr_", "rtree_", "sqlite_"};

std::vector<std::string> viewsIn(sqlite3* database) {
    std::vector<std::string> views;
    const auto rows = prepared(database, "SELECT name FROM sqlite_master WHERE type = 'view'");
    while (rows && sqlite3_step(rows.get()) == SQLITE_ROW) {
        views.emplace_back(textAt(rows.get(), 0));
    }
    return views;
}

/// Asked only where gpkg_contents is a table.
bool isLayer(sqlite3* database, const std::string& name) {
    const auto rows = prepared(database, "SELECT 1 FROM gpkg_contents WHERE lower(table_name) = lower(?)");
    return rows && sqlite3_bind_text(rows.get(), 1, name.c_str(), -1, SQLITE_TRANSIENT) == SQLITE_OK &&
           sqlite3_step(rows.get()) == SQLITE_ROW;
}

/// Of a text that GDAL could not open.
Result<void> checkUnopened(const VectorSource& source) {
    const auto text = systemFileBytes(source.path, source.name);
    return text ? checkGeoJson(*text, source.name, false) : Result<void>{};
}

Error unknownSystem(const Message& where) {
    return inputRefused(where, "the coordinate system that it names is not known",
                        "export the field again in WGS84 (longitude and latitude)");
}

/// What GDAL leaves out, or makes up, in an opened GeoJSON file. Nothing is assumed in the place of a
/// coordinate system that it makes nothing of.
Result<void> checkOpened(const VectorSource& source, const VectorDataset& dataset) {
    const std::string driver = dataset.driver();
    if (driver == "GML" && dataset.hasLayers() && dataset.lacksSystem()) {
        const auto text = systemFileBytes(source.path, source.name);
        return text && text->contains("srsName=") ? std::unexpected(unknownSystem(source.name))
                                                  : Result<void>{};
    }
    if (driver != "GeoJSON" && driver != "GeoJSONSeq" && driver != "JSONFG") {
        return {};
    }
    const auto text = systemFileBytes(source.path, source.name);
    if (!text) {
        return std::unexpected(text.error());
    }
    const auto checked = driver == "GeoJSON" ? checkGeoJson(*text, source.name, true) : Result<void>{};
    const auto isNull =
        checked.and_then([&] { return checkCrs(*text, driver == "GeoJSONSeq", source.name); });
    if (!isNull) {
        return std::unexpected(isNull.error());
    }
    if (dataset.lacksSystem() && !*isNull) {
        return std::unexpected(unknownSystem(source.name));
    }
    return {};
}

bool looksLikeWkt(std::string_view start) {
    const std::string small = inSmallLetters(trimmed(withoutByteOrderMark(start)).substr(0, 32));
    constexpr std::string_view kWords[] = {"polygon",      "multipolygon",       "curvepolygon",
                                           "multisurface", "geometrycollection", "srid="};
    return std::ranges::any_of(kWords, [&small](std::string_view word) { return small.starts_with(word); });
}

/// Reads the text of a source, then what `read` finds in it.
Result<void> readText(const VectorSource& source, const VectorReading& reading,
                      decltype(readWktShapes)& read) {
    const auto text = systemFileBytes(source.path, source.name);
    return text ? read(*text, source.name, reading) : std::unexpected(text.error());
}

/// Why GDAL makes nothing of a source, or its polygons all the same.
Result<void> readUnopened(const VectorSource& source, std::string_view start, const GdalMessages& messages,
                          const VectorReading& reading) {
    if (trimmed(withoutByteOrderMark(start)).starts_with('{')) {
        if (auto checked = checkUnopened(source); !checked) {
            return checked;
        }
    }
    const std::string extension = extensionInSmallLetters(source.path);
    if (extension == ".kml") {
        return readText(source, reading, readPolygonElements);
    }
    if (extension == ".shp") {
        std::filesystem::path index = source.path;
        const bool hasIndex = systemFileExists(index.replace_extension("shx").string()) ||
                              systemFileExists(index.replace_extension("SHX").string());
        if (!hasIndex) {
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

/// Texts are taken apart in memory; tables are read row by row.
Result<void> checkSize(const VectorSource& source, std::string_view start) {
    const std::string_view text = trimmed(withoutByteOrderMark(start));
    const bool isXml =
        text.starts_with('<') || start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF");
    const bool isTable = !isXml && start.contains('\0');
    const std::size_t most = isXml ? kLargestFieldXml : kLargestFieldText;
    if (isTable || systemFileSize(source.path).value_or(0) <= most) {
        return {};
    }
    return std::unexpected(tooLargeText(source.name, most));
}

/// A view may be a question that never ends. The tables of a GeoPackage that say what is in it are none in
/// any good one, and a layer that is one can be exported as a table.
Result<void> checkViews(const VectorSource& source, std::string_view start) {
    if (!start.starts_with(kSqliteMagic)) {
        return {};
    }
    const bool inZip = source.path.starts_with("/vsizip/");
    auto bytes = inZip ? systemFileBytes(source.path, source.name) : Result<std::string>{};
    if (!bytes) {
        return std::unexpected(bytes.error());
    }
    const SqliteDatabase database = inZip ? databaseIn(*bytes) : databaseAt(source.path);
    const std::vector<std::string> views = viewsIn(database.get());
    const auto isOwn = [](const std::string& view) {
        const std::string name = inSmallLetters(view);
        return std::ranges::any_of(kOwnNames, [&name](auto own) { return name.starts_with(own); });
    };
    auto found = std::ranges::find_if(views, isOwn);
    if (found == views.end()) {
        // Now that gpkg_contents is known to be a table.
        found = std::ranges::find_if(views,
                                     [&](const std::string& view) { return isLayer(database.get(), view); });
    }
    return found == views.end()
               ? Result<void>{}
               : std::unexpected(inputRefused(source.name, message("'{}' in it is a view", *found),
                                              "export it as a table, or remove it"));
}

/// The reader of drawings (GDAL 3.10) waits for ever for the line feed after a carriage return that is the
/// file's last character, or stands before a zero. After the last line of all it does not look for one.
Result<void> checkDrawing(const VectorSource& source, std::string_view start) {
    const std::string_view text = trimmed(start);
    const bool begins = text.starts_with("0") || text.starts_with(kDrawingComment);
    const bool isDrawing =
        extensionInSmallLetters(source.path) == ".dxf" || (begins && text.contains("SECTION"));
    if (!isDrawing || text.starts_with(kBinaryDrawing)) {
        return {};
    }
    return systemFileBytes(source.path, source.name).and_then([&](const std::string& all) -> Result<void> {
        const bool isCutOff = all.ends_with('\r') && !all.ends_with("EOF\r");
        return !isCutOff && !all.contains(std::string_view{"\r\0", 2})
                   ? Result<void>{}
                   : std::unexpected(
                         readFailed(source.name, "the file is damaged", "export or copy it again"));
    });
}

Result<void> readSource(const VectorSource& source, const VectorReading& reading) {
    GdalMessages messages;
    const std::string start = systemFileStart(source.path, source.name, 4096).value_or("");
    if (const auto checked =
            checkSize(source, start).and_then([&] { return checkViews(source, start); }).and_then([&] {
                return checkDrawing(source, start);
            });
        !checked) {
        return checked;
    }
    if (extensionInSmallLetters(source.path) == ".wkt" || looksLikeWkt(start)) {
        return readText(source, reading, readWktShapes);
    }
    messages.forget();
    const auto dataset = VectorDataset::open(source.path, messages);
    if (!dataset) {
        return readUnopened(source, start, messages, reading);
    }
    const std::string driver = dataset->driver();
    reading.file.isTable = reading.file.isTable || driver == "CSV";
    reading.file.isTrack = reading.file.isTrack || driver == "GPX";
    if (driver == "CSV") {
        std::ranges::copy(dataset->columns(), std::back_inserter(reading.file.columns));
    }
    if (auto checked = checkOpened(source, *dataset); !checked) {
        return checked;
    }
    // What was said while one driver after the other was tried does not matter once one has opened it.
    messages.forget();
    const std::size_t before = reading.file.features.size();
    auto read = dataset->readLayers(source.path, source.name, messages, reading);
    if (driver == "CSV") {
        for (VectorFeature& row : reading.file.features | std::views::drop(before)) {
            for (std::string& cell : row.attributes) {
                cell = std::string{fromPlainCell(cell)};
            }
        }
    }
    if (read && driver == "GML" && !dataset->hasLayers()) {
        return readText(source, reading, readPolygonElements);
    }
    return read;
}

}  // namespace

Result<VectorFile> readVectorFile(const std::filesystem::path& path,
                                  std::span<const std::string_view> attributes, const JobContext& job) {
    registerGdalDrivers();
    const VectorReadingOptions options;
    const GdalMessages messages;
    const Result<std::vector<VectorSource>> sources = vectorSources(path);
    if (!sources) {
        return std::unexpected(sources.error());
    }
    VectorFile file;
    const VectorReading reading{attributes, job, file};
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
