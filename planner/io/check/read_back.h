#pragma once

#include "planner/io/content/imported_fields.h"

#include <span>
#include <string>
#include <vector>

namespace furrow {

/// Where fields that were read differ from those that were written: parts that are missing or have another
/// area or place (beyond 1 m² and 0.1 %, a decimetre), holes that are neither holes nor obstacles, lines that
/// are missing. More points on the same outline, parts that became fields, and what the format has no place
/// for are no differences. Empty for what was meant. Cost: linear in the points, times the parts.
std::vector<Message> contentDifferences(std::span<const FieldContent> meant, const ImportedFields& read);

}  // namespace furrow
