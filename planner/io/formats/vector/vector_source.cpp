#include "planner/io/formats/vector/vector_source.h"

#include "planner/core/file_error.h"
#include "planner/core/text.h"
#include "planner/io/files/file_folder.h"

#include <algorithm>
#include <set>
#include <system_error>

namespace furrow {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 16;

/// What can be read inside a zip. Files that often only describe the others (.json, .xml, .csv) count
/// where there is nothing else.
std::vector<VectorSource> sourcesInZip(const std::string& path, const std::string& name) {
    const std::string root = systemPathInto(path);
    std::set<std::string> sure;
    std::set<std::string> perhaps;
    constexpr std::string_view kSure[] = {".shp", ".gpkg", ".gml", ".geojson",
                                          ".kml", ".fgb",  ".wkt", ".gpx"};
    constexpr std::string_view kPerhaps[] = {".json", ".xml", ".csv"};
    for (const std::string& listed : namesBelow(root)) {
        const fs::path entry{listed};
        if (listed.starts_with("__MACOSX") || entry.filename().string().starts_with("._")) {
            continue;
        }
        if (const std::size_t end = inSmallLetters(listed).find(".gdb/"); end != std::string::npos) {
            sure.insert(listed.substr(0, end + 4));
            continue;
        }
        const std::string extension = extensionInSmallLetters(entry);
        if (extension == ".gdbtable") {
            // A geodatabase zipped without its folder: its driver takes the zip itself.
            return {{path, name}};
        }
        if (std::ranges::contains(kSure, extension)) {
            sure.insert(listed);
        } else if (std::ranges::contains(kPerhaps, extension)) {
            perhaps.insert(listed);
        }
    }
    std::vector<VectorSource> sources;
    for (const std::string& entry : sure.empty() ? perhaps : sure) {
        sources.push_back({root + "/" + entry, message("{}, {}", name, entry)});
    }
    return sources;
}

/// Of a shapefile people may choose any of its files.
fs::path mainFileOf(const fs::path& path) {
    constexpr std::string_view kCompanions[] = {".shx", ".dbf", ".prj", ".cpg"};
    if (std::ranges::contains(kCompanions, extensionInSmallLetters(path))) {
        for (const char* extension : {".shp", ".SHP"}) {
            fs::path shapes = path;
            shapes.replace_extension(extension);
            if (fs::exists(shapes)) {
                return shapes;
            }
        }
    }
    return path;
}

}  // namespace

Result<std::vector<VectorSource>> vectorSources(const fs::path& chosen) {
    const std::string name = chosen.filename().string();
    const std::string text = chosen.string();
    if (text.find("://") != std::string::npos || text.starts_with("/vsi")) {
        return std::unexpected(
            readFailed(text, "only files on this computer are read", "download the file and give its path"));
    }
    std::error_code failed;
    const fs::file_status status = fs::status(chosen, failed);
    if (fs::is_directory(status)) {
        if (extensionInSmallLetters(chosen) == ".gdb") {
            return std::vector<VectorSource>{{fs::absolute(chosen).string(), name}};
        }
        return std::unexpected(readFailed(text, "this is a folder", "give one of the files in it"));
    }
    const fs::path meant = fs::exists(status) ? mainFileOf(chosen) : chosen;
    const auto start = fileStart(meant, 4);
    if (!start) {
        return std::unexpected(start.error());
    }
    // Absolute, so that no part of the name can be taken for a prefix of GDAL's.
    const std::string path = fs::absolute(meant).string();
    if (!isZip(*start)) {
        return std::vector<VectorSource>{{path, name}};
    }
    // For its bounds only: GDAL lists the zip in its own way.
    if (const auto bounded = FileFolder::open(path, kDeepest); !bounded) {
        return std::unexpected(bounded.error());
    }
    std::vector<VectorSource> sources = sourcesInZip(path, name);
    if (sources.empty()) {
        return std::unexpected(
            readFailed(text, "there is no boundary file in this zip", std::string{kBoundaryFormats}));
    }
    return sources;
}

}  // namespace furrow
