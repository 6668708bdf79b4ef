#pragma once

#include "planner/core/file_in_memory.h"
#include "planner/core/result.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// A zip of these files, deflated, in memory. WriteFailed.
Result<std::string> zipOf(std::span<const FileInMemory> files);

/// What is in a zip of our own making; nothing where it is none.
std::vector<FileInMemory> filesInZip(std::string_view zip);

}  // namespace furrow
