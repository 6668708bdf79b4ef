#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>

namespace furrow {

// Values of a JSON text that may be anything.

/// Not finite where there is no number.
double numberAt(const nlohmann::json& array, std::size_t index);

/// The value of a member; null where there is none.
const nlohmann::json& memberOf(const nlohmann::json& object, const char* name);

/// Empty where it is no text.
std::string textOf(const nlohmann::json& value);

}  // namespace furrow
