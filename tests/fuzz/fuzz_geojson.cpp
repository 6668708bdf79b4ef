#include "planner/io/formats/geojson/geojson_check.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    (void)checkGeoJson(text, "fuzz", true);
    (void)checkGeoJson(text, "fuzz", false);
    return 0;
}
