#pragma once

#include "planner/core/result.h"
#include "planner/machine/machine.h"

#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace furrow {

/// A value of a machine file. Empty if it is not given.
using MachineValue = std::variant<std::monostate, double, bool, std::string>;

enum class MachineKeyKind { Number, Flag, Text };

/// One key of a machine file and its member. Reading, writing and every list of a machine's values use the
/// same table of these.
struct MachineKey {
    std::string_view key;  ///< as in the file: "operating_width_m"
    MachineKeyKind kind = MachineKeyKind::Number;
    std::string_view name;         ///< as shown to people: "Operating width"
    std::string_view unit;         ///< "m", "m/s", "°" ...; empty for flags, texts and the user's own unit
    std::string_view description;  ///< one sentence
    /// The usual range of a number, for input fields. A file may go beyond.
    double min = 0.0;
    double max = 0.0;
    /// What real machines fit into with room. Nothing is planned beyond it.
    double least = 0.0;
    double most = 0.0;
    bool mayBeMissing = false;                  ///< has a meaning if not given; clearing it restores that
    std::span<const std::string_view> choices;  ///< of a text; empty if any text is allowed

    /// In the unit of the key.
    MachineValue (*get)(const MachineSpec& spec);
    /// The value must be of the key's kind and, if there are choices, one of them. An empty value clears a
    /// key that may be missing.
    void (*set)(MachineSpec& spec, const MachineValue& value);
};

/// All keys, in the order of writing.
std::span<const MachineKey> machineKeys();

/// InputRefused, naming the key: a number that is not finite, or beyond what real machines have. The remedy
/// asks for the value in the unit of the key where millimetres, centimetres or km/h were given.
Result<void> checkRanges(const MachineSpec& spec);

}  // namespace furrow
