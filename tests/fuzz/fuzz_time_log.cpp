#include "planner/io/formats/isoxml/isoxml.h"

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <format>
#include <fstream>
#include <string_view>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    // A task, the header of its log, and the log itself, divided by a line "====".
    namespace fs = std::filesystem;
    static const fs::path folder = fs::temp_directory_path() / std::format("fuzz_{}", ::getpid());
    fs::create_directories(folder);
    for (const char* name : {"TASKDATA.XML", "TLG00001.XML", "TLG00001.BIN"}) {
        const std::size_t end = std::min(text.find("\n====\n"), text.size());
        std::ofstream{folder / name, std::ios::binary} << text.substr(0, end);
        text.remove_prefix(std::min(end + 6, text.size()));
    }
    if (const auto opened = FileFolder::open(folder)) {
        (void)isoxmlTracks(*opened, "fuzz", {});
    }
    return 0;
}
