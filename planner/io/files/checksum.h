#pragma once

#include <cstdint>
#include <string_view>

namespace furrow {

/// The checksum of zip files (CRC-32, ISO 3309), which MCAP uses, too.
std::uint32_t crc32Of(std::string_view bytes);

}  // namespace furrow
