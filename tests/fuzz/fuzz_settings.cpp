#include "planner/io/plan_files/settings_file.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace furrow;

/// Whatever the bytes are: no crash, no bad address, no memory without bounds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view text{reinterpret_cast<const char*>(data), size};
    Settings settings;
    (void)applySettingsJson(settings, text, "fuzz");
    return 0;
}
