#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace furrow {

/// Numbers of items in slots (the cells of a grid, or its rows) in one piece of memory. Those of a slot are
/// in the order in which they came.
class SlottedItems {
public:
    SlottedItems() = default;
    /// @param forEach  forEach(take) calls take(slot, item) for each pair, twice in the same order
    template <class ForEach>
    SlottedItems(std::size_t slots, const ForEach& forEach) : first_(slots + 1, 0) {
        forEach([&](std::size_t slot, std::uint32_t) { ++first_[slot + 1]; });
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        items_.resize(first_.back());
        std::vector<std::uint32_t> next{first_.begin(), first_.end() - 1};
        forEach([&](std::size_t slot, std::uint32_t item) { items_[next[slot]++] = item; });
    }

    std::span<const std::uint32_t> in(std::size_t slot) const {
        return std::span{items_}.subspan(first_[slot], first_[slot + 1] - first_[slot]);
    }

private:
    std::vector<std::uint32_t> first_;  ///< place of the first item of each slot, and the end
    std::vector<std::uint32_t> items_;
};

}  // namespace furrow
