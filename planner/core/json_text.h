#pragma once

#include "planner/core/message.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <expected>
#include <optional>
#include <string_view>

namespace furrow {

/// Levels of lists and objects in one another that a JSON text may have. No file of ours or of others needs
/// more than some twenty; what copies and writes JSON takes stack for each.
inline constexpr int kDeepestJson = 100;

/// Why a JSON text is not taken, in parts of an Error.
struct JsonFault {
    Message what;
    Message place;  ///< "line 2, column 29"; empty where it is the whole
    Message remedy;
};

enum class JsonKeys { MayRepeat, Unique };

/// The one way in which JSON from files is read; `Json` is nlohmann::json or nlohmann::ordered_json. A byte
/// order mark is left out.
///
/// @param keys  Unique: a key that an object has twice is a fault, too
template <class Json>
std::expected<Json, JsonFault> readJson(std::string_view text, JsonKeys keys = JsonKeys::MayRepeat);

/// The same where only JSON or not matters: discarded where it is not taken.
template <class Json>
Json jsonOrDiscarded(std::string_view text, int deepest = kDeepestJson);

extern template std::expected<nlohmann::json, JsonFault> readJson(std::string_view, JsonKeys);
extern template std::expected<nlohmann::ordered_json, JsonFault> readJson(std::string_view, JsonKeys);
extern template nlohmann::json jsonOrDiscarded(std::string_view, int);
extern template nlohmann::ordered_json jsonOrDiscarded(std::string_view, int);

/// Where a text goes deeper, if it does.
std::optional<std::size_t> jsonTooDeepAt(std::string_view text, int deepest = kDeepestJson);

}  // namespace furrow
