#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace furrow {

/// The largest growth of this program's memory in bytes while `work` runs, as the system counts its pages.
/// Memory freed before, but not given back, counts as free. Other threads' allocations count, too. Empty if
/// the system gives no figure (Linux does).
std::optional<std::size_t> peakMemoryOf(const std::function<void()>& work);

}  // namespace furrow
