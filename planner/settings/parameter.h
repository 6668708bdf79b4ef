#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace furrow {

enum class ParameterKind {
    Length,
    Angle,
    Count,
    Percent,
    Choice,
    Flag,
    Line,     ///< points in WGS84 as WKT: "LINESTRING (4.1 52.0, 4.2 52.0)"; empty where there are none
    Lines,    ///< several of them: "MULTILINESTRING (...)", "GEOMETRYCOLLECTION (...)" or one LINESTRING
    File,     ///< the path of a file; empty where there is none
    Place,    ///< the name of a gate, or a point as WKT; empty where there is none
    Places,   ///< several of them, divided by semicolons, or one "MULTIPOINT (...)"
    Numbers,  ///< whole numbers divided by commas: "3,-1,2"; empty where there are none
};

/// Kinds whose values are text without a list to choose from: empty until they are given.
bool isText(ParameterKind kind);

/// "Auto": the planner computes the number, and the plan says which one it used.
struct Auto {
    friend bool operator==(Auto, Auto) = default;
};

/// Lengths in metres, angles in degrees, counts as whole numbers: what a settings file holds.
using SettingValue = std::variant<Auto, double, bool, std::string>;

/// One value that a choice may have.
struct Choice {
    std::string_view id;           ///< as in settings files
    std::string_view name;         ///< as people see it
    std::string_view description;  ///< one sentence
};

/// One setting of a stage or of a method: what the panel, the command line and the checks read.
struct Parameter {
    std::string_view key;          ///< "headland.width_m"
    std::string_view name;         ///< "Width"
    std::string_view description;  ///< one sentence for people
    ParameterKind kind = ParameterKind::Length;
    /// The default: a number, nothing for "auto", or the index of a choice; 0 and 1 for flags; not used by
    /// lines and lists, which are empty until they are given.
    std::optional<double> standard;
    bool canBeAuto = false;
    double min = 0.0;   ///< smallest allowed number
    double max = 0.0;   ///< largest allowed number
    double step = 1.0;  ///< a sensible step for arrow keys
    std::span<const Choice> choices;
    /// Key of the setting that says the same in other words; who gives one takes back the other. Empty for
    /// most.
    std::string_view excludes = {};

    SettingValue defaultValue() const;
};

}  // namespace furrow
