#pragma once

#include "planner/core/result.h"
#include "planner/machine/machine.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace furrow {

/// A value of a machine file: nothing where it is not given.
using MachineValue = std::variant<std::monostate, double, bool, std::string>;

enum class MachineKeyKind { Number, Flag, Text };

/// One key of a machine file and the member it stands for. Reading, writing and every list of a machine's
/// values go through the same table of these.
struct MachineKey {
    std::string_view key;  ///< as in the file: "operating_width_m"
    MachineKeyKind kind = MachineKeyKind::Number;
    std::string_view name;         ///< as people see it: "Operating width"
    std::string_view unit;         ///< "m", "m/s", "°" ...; empty for flags, texts and the user's own unit
    std::string_view description;  ///< one sentence
    /// The usual range of a number, for input fields. A file may go beyond: what can be planned with is
    /// for Machine::create to say.
    double min = 0.0;
    double max = 0.0;
    bool mayBeMissing = false;  ///< has a meaning where it is not given; clearing it brings that back
    std::span<const std::string_view> choices;  ///< of a text; empty where any text will do

    /// In the unit of the key.
    MachineValue (*get)(const MachineSpec& spec);
    /// The value must be of the key's kind and, where there are choices, one of them; nothing clears what
    /// may be missing.
    void (*set)(MachineSpec& spec, const MachineValue& value);
};

/// All keys, in the order they are written.
std::span<const MachineKey> machineKeys();

/// Reads a machine: one flat JSON object with keys of machineKeys(). What is not given keeps its default;
/// operating_width_m must be given, and a trailed implement reverses only where the file says so.
///
/// @param origin  where the text came from, for messages; its file name is the name of a machine without one
/// @return InputRefused, with the place: not JSON (line and column), not an object, a key that is not
///         known (naming the nearest one) or there twice, a value of another kind, and what
///         Machine::create refuses.
Result<Machine> parseMachine(std::string_view json, std::string_view origin);

/// The same from a file. ReadFailed: not there, not readable.
Result<Machine> readMachineFile(const std::filesystem::path& path);

/// The machine as parseMachine reads it, equal to the last bit; ends with a line break.
std::string machineJson(const MachineSpec& spec);

}  // namespace furrow
