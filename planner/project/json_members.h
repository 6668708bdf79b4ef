#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <string>
#include <string_view>

namespace furrow {

using OrderedJson = nlohmann::ordered_json;

/// The members of an object that are not named here, as text; empty where there are none.
std::string otherMembers(const OrderedJson& object, std::initializer_list<std::string_view> known);

/// Adds such members again; those that are there already stay.
void addMembers(OrderedJson& object, std::string_view others);

/// In the fewest digits that read back to the same numbers; what is no UTF-8 is replaced.
std::string textOf(const OrderedJson& json);

}  // namespace furrow
