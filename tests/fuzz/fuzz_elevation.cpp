#include "planner/gdal/elevation.h"
#include "tests/fuzz/joined_files.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds. The first byte chooses what
/// the file is called, the second where the field lies.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    constexpr std::array kNames = {"heights.tif", "heights.asc", "N49E006.hgt", "heights.dt1", "heights.vrt"};
    // Luxembourg and Texas, where the seeds lie; the corner of all grids of degrees.
    constexpr std::array<GeoPoint, 3> kPlaces = {{{6.1, 49.7}, {-100.0, 32.0}, {0.0, 0.0}}};
    if (text.size() < 2) {
        return 0;
    }
    static const std::filesystem::path folder = fuzz::ownFolder();
    const std::filesystem::path path = folder / kNames[static_cast<unsigned char>(text[0]) % kNames.size()];
    std::ofstream{path, std::ios::binary} << text.substr(2);
    const auto frame = LocalFrame::centredOn(kPlaces[static_cast<unsigned char>(text[1]) % kPlaces.size()]);
    (void)readElevation(path, *frame, {{-200.0, -150.0}, {200.0, 150.0}}, {});
    std::filesystem::remove(path);
    return 0;
}
