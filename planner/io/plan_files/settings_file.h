#pragma once

#include "planner/core/result.h"
#include "planner/settings/settings.h"

#include <filesystem>
#include <string_view>

namespace furrow {

/// Adds the settings of a JSON object, flat ({"headland.width_m": 12}) or nested ({"headland": {"width_m":
/// 12}}), as summary.json holds them. Errors: Usage for unknown keys and choices, InputRefused for text that
/// is no JSON object and for values that do not fit, each with its place.
Result<void> applySettingsJson(Settings& settings, std::string_view json, std::string_view origin);

/// The same from a file. ReadFailed.
Result<void> applySettingsFile(Settings& settings, const std::filesystem::path& path);

}  // namespace furrow
