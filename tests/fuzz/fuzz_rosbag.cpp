#include "planner/io/formats/ros/ros.h"
#include "tests/fuzz/joined_files.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    // It reads from files; this one is in memory where the system has such a place.
    static const std::filesystem::path path = fuzz::ownFolder() / "a.mcap";
    std::ofstream{path, std::ios::binary} << text;
    (void)rosbagTracks({path}, "fuzz", {});
    return 0;
}
