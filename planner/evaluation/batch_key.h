#pragma once

#include "planner/evaluation/batch.h"
#include "planner/project/field_tasks.h"

#include <filesystem>
#include <string>

namespace furrow {

/// A short text for the common inputs of a batch: the machine and the settings given, formats, the version of
/// Furrow. It differs if any of these differ.
std::string runKey(const BatchTask& task);

/// The same for one field's result, including its source and all inputs of its plan.
///
/// @param file  absolute
std::string fieldKey(const std::filesystem::path& file, std::size_t number, const FieldTask& field,
                     const std::string& run);

}  // namespace furrow
