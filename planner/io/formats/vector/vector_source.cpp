#include "planner/io/formats/vector/vector_source.h"

#include "planner/core/file_error.h"
#include "planner/io/files/file_folder.h"

#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <format>
#include <set>
#include <system_error>

namespace furrow {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 16;

/// What can be read inside a zip. Files that often only describe the others (.json, .xml, .csv) count
/// where there is nothing else.
std::vector<BoundarySource> sourcesInZip(const std::string& path, const std::string& name) {
    // Braces keep a name with blanks, brackets or another ".zip" in it in one piece.
    const std::string root = std::format("/vsizip/{{{}}}", path);
    const CPLStringList entries{VSIReadDirRecursive(root.c_str())};
    std::set<std::string> sure;
    std::set<std::string> perhaps;
    constexpr std::string_view kSure[] = {".shp", ".gpkg", ".gml", ".geojson",
                                          ".kml", ".fgb",  ".wkt", ".gpx"};
    constexpr std::string_view kPerhaps[] = {".json", ".xml", ".csv"};
    for (int i = 0; i < entries.size(); ++i) {
        const fs::path entry{entries[i]};
        const std::string fileName = entry.filename().string();
        if (std::string_view{entries[i]}.starts_with("__MACOSX") || fileName.starts_with("._")) {
            continue;
        }
        if (const std::size_t end = inSmallLetters(entries[i]).find(".gdb/"); end != std::string::npos) {
            sure.insert(std::string{entries[i]}.substr(0, end + 4));
            continue;
        }
        const std::string extension = extensionInSmallLetters(entry);
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
    std::vector<BoundarySource> sources;
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

Result<std::vector<BoundarySource>> boundarySources(const fs::path& chosen) {
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
            return std::vector<BoundarySource>{{fs::absolute(chosen).string(), name}};
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
        return std::vector<BoundarySource>{{path, name}};
    }
    // For its bounds only: GDAL lists the zip in its own way.
    if (const auto bounded = FileFolder::open(path, kDeepest); !bounded) {
        return std::unexpected(bounded.error());
    }
    std::vector<BoundarySource> sources = sourcesInZip(path, name);
    if (sources.empty()) {
        return std::unexpected(
            readFailed(text, "there is no boundary file in this zip", std::string{kBoundaryFormats}));
    }
    return sources;
}

}  // namespace furrow
