#pragma once

#include <cstdint>
#include <string_view>

namespace furrow {

// What MCAP files are made of (https://mcap.dev/spec), for reading and writing them.

/// At the beginning and at the end of a file.
inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

namespace mcap {

enum Opcode : std::uint8_t {
    kHeader = 1,
    kFooter = 2,
    kSchema = 3,
    kChannel = 4,
    kMessage = 5,
    kChunk = 6,
    kMessageIndex = 7,
    kChunkIndex = 8,
    kStatistics = 11,
    kDataEnd = 15,
};

}  // namespace mcap

}  // namespace furrow
