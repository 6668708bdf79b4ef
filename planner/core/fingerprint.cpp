#include "planner/core/fingerprint.h"

#include <cstdint>
#include <format>

namespace furrow {

std::string fingerprint(std::string_view bytes) {
    // FNV-1a.
    std::uint64_t hash = 14695981039346656037U;
    for (const char byte : bytes) {
        hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
    }
    return std::format("{:016x}-{}", hash, bytes.size());
}

}  // namespace furrow
