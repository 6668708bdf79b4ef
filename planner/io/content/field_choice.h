#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace furrow {

/// The field that is meant: by its id, its name, or its number in the list from 1, in this order.
///
/// @param fieldId  may be left out where there is only one field
/// @return Usage, listing fields or naming near ones: several fields and no id, no such field, an id that
///         several fields share.
Result<std::size_t> pickFieldIndex(std::span<const FieldSource> fields,
                                   std::optional<std::string_view> fieldId);
/// The field itself.
Result<FieldSource> pickField(std::span<const FieldSource> fields, std::optional<std::string_view> fieldId);

/// On the ellipsoid, holes taken out, obstacles not; of what was read, before any repair.
Area areaOf(const FieldSource& field);

}  // namespace furrow
