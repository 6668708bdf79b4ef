#include "planner/io/formats/agopengps/agopengps_reader.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    // One text for all files of a field: "name\n", its lines, and a line "====" before the next name.
    std::map<std::string, std::string, std::less<>> files;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find("\n====\n"), text.size());
        const std::string_view file = text.substr(0, end);
        const std::size_t name = std::min(file.find('\n'), file.size());
        files[std::string{file.substr(0, name)}] = file.substr(std::min(name + 1, file.size()));
        text.remove_prefix(std::min(end + 6, text.size()));
    }
    const AgOpenGpsFile file = [&files](std::string_view name) {
        const auto found = files.find(name);
        return found == files.end() ? std::nullopt : std::optional{found->second};
    };
    (void)readAgOpenGps("fuzz", file);
    return 0;
}
