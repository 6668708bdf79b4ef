#pragma once

#include "planner/core/message.h"
#include "planner/geometry/point.h"

#include <optional>
#include <string>
#include <string_view>

namespace furrow {

enum class Severity { Blocking, Note };

/// One setting and its new value, as in `--set key=value`.
struct SettingChange {
    std::string key;
    std::string value;

    friend bool operator==(const SettingChange&, const SettingChange&) = default;
};

/// Something that the user must or should know about a plan, with its place.
struct Finding {
    Severity severity = Severity::Note;
    FindingKind kind = FindingKind::Setting;
    Point place;
    Message text;        ///< what and why
    Message suggestion;  ///< what would correct it
    /// The change in the suggestion, if one setting corrects it. Planned again with this change, the finding
    /// is gone and nothing else blocks.
    std::optional<SettingChange> change = {};
    /// The setting that a note of kind Setting is about: its key.
    std::string setting = {};

    friend bool operator==(const Finding&, const Finding&) = default;
};

/// "outside", "missed", "swaths.min_length_m": as files and the command line name it.
std::string_view kindId(const Finding& finding);
std::string_view kindId(FindingKind kind);

}  // namespace furrow
