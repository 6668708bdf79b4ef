#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace furrow {

/// Reads numbers of a given size from bytes in memory, front to back. Past the end it answers zeros and
/// remembers it: ask `ok` after a record, not after every number.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes, std::endian order = std::endian::little)
        : bytes_{bytes}, order_{order} {}

    template <std::integral T>
    T integer() {
        std::array<char, sizeof(T)> raw{};
        std::ranges::copy(take(sizeof(T)), raw.begin());
        const T value = std::bit_cast<T>(raw);
        return order_ == std::endian::native ? value : std::byteswap(value);
    }
    double real() { return std::bit_cast<double>(integer<std::uint64_t>()); }

    std::string_view take(std::size_t count) {
        if (count > bytesLeft()) {
            ok_ = false;
            at_ = bytes_.size();
            return {};
        }
        const std::string_view taken = bytes_.substr(at_, count);
        at_ += count;
        return taken;
    }
    void skip(std::size_t count) { take(count); }
    /// Forward to a multiple of `size`, counted from the beginning.
    void align(std::size_t size) { skip((size - at_ % size) % size); }

    bool ok() const { return ok_; }
    std::size_t at() const { return at_; }
    std::size_t bytesLeft() const { return bytes_.size() - at_; }

private:
    std::string_view bytes_;
    std::endian order_;
    std::size_t at_ = 0;
    bool ok_ = true;
};

}  // namespace furrow
