#include "planner/io/import/field_reader.h"
#include "tests/fuzz/joined_files.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds. Files that GDAL opens, with
/// what is our own behind it: rows of tables, well-known text, polygons without a driver, drawings, zips,
/// traced rasters.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    namespace fs = std::filesystem;
    constexpr std::array kNames = {"a.csv",  "a.wkt", "a.gml", "a.kml",           "a.kmz", "a.zip",
                                   "a.json", "a.gpx", "a.png", "a_EPSG32632.dxf", "a.tif"};
    if (text.empty()) {
        return 0;
    }
    static const fs::path folder = fuzz::ownFolder();
    const fs::path path = folder / kNames[static_cast<unsigned char>(text.front()) % kNames.size()];
    std::ofstream{path, std::ios::binary} << text.substr(1);
    (void)readFields(path);
    fs::remove(path);
    return 0;
}
