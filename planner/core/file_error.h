#pragma once

#include "planner/core/error.h"

#include <string>
#include <utility>

namespace furrow {

/// A file that could not be read: not there, not readable, damaged.
inline Error readFailed(Message where, Message what, Message remedy) {
    return {.code = ErrorCode::ReadFailed,
            .what = std::move(what),
            .where = std::move(where),
            .remedy = std::move(remedy)};
}

/// A file that was read and holds what cannot be planned with.
inline Error inputRefused(Message where, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = std::move(where),
            .remedy = std::move(remedy)};
}

}  // namespace furrow
