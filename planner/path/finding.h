#pragma once

#include "planner/core/message.h"
#include "planner/geometry/point.h"

#include <optional>
#include <string>
#include <string_view>

namespace furrow {

enum class Severity { Blocking, Note };

/// What a finding is about. Files and the command line name it by its id.
enum class FindingKind {
    Outside,              ///< leaves where the machine may be
    Obstacle,             ///< crosses an obstacle
    Undrivable,           ///< the planner found no way
    Curvature,            ///< bends more sharply than the machine
    MissingTurn,          ///< nothing leads from one pass to the next
    Jump,                 ///< the path jumps
    Heading,              ///< moves sideways
    HeadingJump,          ///< turns on the spot
    Reverse,              ///< drives backwards, and cannot
    DroppedPass,          ///< a headland pass is not on the path
    DroppedSwath,         ///< a swath is not on the path
    Missed,               ///< land within reach is not worked
    OutOfReach,           ///< land that the machine cannot reach
    Overhang,             ///< the implement stands over an edge, as it may
    HeadlandNotWorked,    ///< the strip is kept for turning only
    CurvatureRate,        ///< the steering has to turn too fast
    StatedCurvature,      ///< states another curvature than it has
    Speed,                ///< states more than the machine can
    LateralAcceleration,  ///< is too fast for its bends
    Time,                 ///< states times that do not fit
    LanesCrossed,         ///< drives over worked land
    HitchAngle,           ///< bends the hitch too far
    Gate,                 ///< of the ways in and out
    TurnKind,             ///< a turn of another kind than chosen
    Folded,               ///< a way is driven with the implement folded
    Refill,               ///< the tank is empty, or a refill point is out of reach
    Repair,               ///< the boundary was repaired
    Instead,              ///< another choice was quicker
    Setting,              ///< a note of a stage about one of its settings
};

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

/// How much a finding matters to whoever drives.
enum class Weight {
    Blocks,       ///< the plan cannot be driven as it is
    Look,         ///< costs something or wants a decision
    Information,  ///< is just so: a choice that was made, a drawing error that was put right
};

/// What blocks; what can be changed or leaves land or a machine's limit out; and all the rest.
Weight weightOf(const Finding& finding);

/// "outside", "missed", "swaths.min_length_m": as files and the command line name it.
std::string_view kindId(const Finding& finding);
std::string_view kindId(FindingKind kind);

}  // namespace furrow
