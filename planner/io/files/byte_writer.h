#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace furrow {

/// Numbers of a given size as little-endian bytes, one behind the other; ByteReader's counterpart.
class ByteWriter {
public:
    template <std::integral T>
    void integer(T value) {
        auto rest = static_cast<std::uint64_t>(value);
        for (std::size_t i = 0; i < sizeof(T); ++i, rest >>= 8) {
            bytes_ += static_cast<char>(rest & 0xFF);
        }
    }
    void real(double value) { integer(std::bit_cast<std::uint64_t>(value)); }
    void bytes(std::string_view some) { bytes_ += some; }
    /// Zeros up to a multiple of `size`, counted from the beginning.
    void align(std::size_t size) { bytes_.append((size - bytes_.size() % size) % size, '\0'); }

    std::size_t size() const { return bytes_.size(); }
    std::string take() && { return std::move(bytes_); }

private:
    std::string bytes_;
};

}  // namespace furrow
