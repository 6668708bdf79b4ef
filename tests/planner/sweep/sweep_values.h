#pragma once

#include "planner/plan/plan.h"
#include "planner/settings/parameter.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::test {

/// Where a setting is tried.
struct SweepSite {
    std::shared_ptr<const Field> field;
    Machine machine;
    std::shared_ptr<const Plan> standard;  ///< with default settings; none where that is refused
    std::filesystem::path folder;          ///< for files that settings name
};

/// A value that a user may give a setting: a number, or words for what is worked out for each field.
struct SweepValue {
    std::string label;  ///< "0.5", "along the longest edge"
    /// As in `--set key=value`; nothing where there is no such value at this site.
    std::function<std::optional<std::string>(const SweepSite&)> text;
    /// The plan has to say something of it, or it is refused: it cannot be obeyed.
    bool mustBeTold = false;
};

/// What users give this setting, while `method` (its id) is the one of the setting's stage. Never empty.
std::vector<SweepValue> sweepValues(const Parameter& parameter, std::string_view method);

/// A value that is the same everywhere.
SweepValue fixedValue(std::string text);

}  // namespace furrow::test
