#pragma once

#include "planner/core/text.h"
#include "planner/units/quantity.h"

#include <pugixml.hpp>

#include <optional>
#include <string_view>

// Attributes of ISO 11783-10 as they are read.

namespace furrow::isoxml {

inline std::string_view attribute(pugi::xml_node node, const char* name) {
    return node.attribute(name).value();
}

/// A length above 0.
inline std::optional<Length> millimetres(std::string_view text) {
    const auto number = plainDecimalIn(text);
    return number && *number > 0.0 ? std::optional{metres(*number / 1000.0)} : std::nullopt;
}

}  // namespace furrow::isoxml
