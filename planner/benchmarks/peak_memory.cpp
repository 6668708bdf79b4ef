#include "planner/benchmarks/peak_memory.h"

#include <fstream>
#include <string>
#include <string_view>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace furrow {

namespace {

/// A figure of /proc/self/status, which has lines like "VmHWM:     12345 kB".
std::optional<std::size_t> statusBytes(std::string_view key) {
    std::ifstream status{"/proc/self/status"};
    for (std::string name; status >> name;) {
        std::size_t kibibytes = 0;
        if (name == key && status >> kibibytes) {
            return kibibytes * 1024;
        }
        std::getline(status, name);
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::size_t> peakMemoryOf(const std::function<void()>& work) {
#ifdef __GLIBC__
    // Pages that earlier work has left to the allocator would hide the need of this one.
    malloc_trim(0);
#endif
    const auto before = statusBytes("VmRSS:");
    // 5 resets the peak to the memory in use now.
    const bool reset = (std::ofstream{"/proc/self/clear_refs"} << 5 << std::flush).good();
    work();
    const auto peak = statusBytes("VmHWM:");
    if (!before || !reset || !peak) {
        return std::nullopt;
    }
    return *peak > *before ? *peak - *before : 0;
}

}  // namespace furrow
