#pragma once

#include "planner/core/message.h"
#include "planner/core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace furrow {

/// The text behind the mark that some programs begin UTF-8 with.
std::string_view withoutByteOrderMark(std::string_view text);

/// The text of a file that a person may have written, or of a pipe: a machine, settings. ReadFailed, with
/// this remedy: not there, a folder, not readable. InputRefused: more than 16 MiB.
Result<std::string> writtenText(const std::filesystem::path& path, const Message& remedy);

/// "line 2, column 29": where an offset from 0 is, both counted from 1 as editors do.
Message lineAndColumn(std::string_view text, std::size_t offset);

}  // namespace furrow
