#pragma once

#include "planner/units/quantity.h"

#include <pugixml.hpp>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

// Attributes of ISO 11783-10 as they are read.

namespace furrow::isoxml {

inline std::string_view attribute(pugi::xml_node node, const char* name) {
    return node.attribute(name).value();
}

/// A plain decimal; no exponent, no comma.
inline std::optional<double> decimal(std::string_view text) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
    const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(number);
    return whole ? std::optional{number} : std::nullopt;
}

/// A length above 0.
inline std::optional<Length> millimetres(std::string_view text) {
    const auto number = decimal(text);
    return number && *number > 0.0 ? std::optional{metres(*number / 1000.0)} : std::nullopt;
}

}  // namespace furrow::isoxml
