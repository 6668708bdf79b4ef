#pragma once

#include "planner/core/message.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace furrow {

/// The text behind the mark that some programs begin UTF-8 with.
std::string_view withoutByteOrderMark(std::string_view text);

/// "line 2, column 29": where an offset from 0 is, both counted from 1 as editors do.
Message lineAndColumn(std::string_view text, std::size_t offset);

}  // namespace furrow
