#pragma once

#include "planner/evaluation/batch.h"
#include "planner/project/field_tasks.h"

#include <filesystem>
#include <string>

namespace furrow {

/// What a whole batch has in common, as a short text that differs where it differs: the machine and the settings that
/// are asked for, formats, the version of Furrow.
std::string runKey(const BatchTask& task);

/// The same of one field's result, with where it was read from and everything that its plan is made from.
///
/// @param file  absolute
std::string fieldKey(const std::filesystem::path& file, std::size_t number, const FieldTask& field, const std::string& run);

}  // namespace furrow
