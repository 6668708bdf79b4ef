#pragma once

#include "planner/core/error.h"

#include <expected>

namespace furrow {

/// A value, or the reason why there is none.
template <class T>
using Result = std::expected<T, Error>;

}  // namespace furrow
