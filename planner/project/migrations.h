#pragma once

#include "planner/core/result.h"
#include "planner/project/json_members.h"

#include <span>

namespace furrow {

/// What the project files of this version say as `format_version`.
inline constexpr int kProjectVersion = 1;

/// Brings a file of one version to the next one.
using Migration = void (*)(OrderedJson& document);

/// Brings a document of `version` to the version after the last of these steps; step 0 leads from version 1
/// to 2. InputRefused: a version below 1, or one that is newer than the steps lead to.
Result<OrderedJson> migrated(OrderedJson document, int version, std::span<const Migration> steps,
                             const std::string& origin);

/// Those from version 1 to kProjectVersion.
std::span<const Migration> projectMigrations();

}  // namespace furrow
