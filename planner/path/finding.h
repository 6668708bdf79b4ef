#pragma once

#include "planner/core/message.h"
#include "planner/geometry/point.h"

#include <optional>
#include <string>

namespace furrow {

enum class Severity { Blocking, Note };

/// One setting and what to set it to, as `--set key=value` has it.
struct SettingChange {
    std::string key;
    std::string value;

    friend bool operator==(const SettingChange&, const SettingChange&) = default;
};

/// Something the user must or should know about a plan, with its place.
struct Finding {
    Severity severity = Severity::Note;
    std::string kind;  ///< "outside", "obstacle", "headland", "repair" ...
    Point place;
    Message text;        ///< what and why
    Message suggestion;  ///< what would mend it
    /// What the suggestion asks for, where one setting mends it. Planned again with it, the finding is gone and no
    /// other one blocks.
    std::optional<SettingChange> change = {};

    friend bool operator==(const Finding&, const Finding&) = default;
};

}  // namespace furrow
