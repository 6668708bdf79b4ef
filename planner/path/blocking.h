#pragma once

#include "planner/path/finding.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace furrow {

/// While it stands, the plan cannot be driven as it is.
constexpr bool isBlocking(const Finding& finding) {
    return finding.severity == Severity::Blocking;
}

inline std::ptrdiff_t blockingCount(std::span<const Finding> findings) {
    return std::ranges::count_if(findings, isBlocking);
}

}  // namespace furrow
