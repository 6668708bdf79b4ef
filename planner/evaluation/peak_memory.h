#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace furrow {

/// By how many bytes the memory of this program grows at most while `work` runs, as the system counts its
/// pages; what is freed and not given back before counts as not there. Other threads' allocations count, too.
/// Nothing where the system does not tell (Linux does).
std::optional<std::size_t> peakMemoryOf(const std::function<void()>& work);

}  // namespace furrow
