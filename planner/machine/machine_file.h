#pragma once

#include "planner/core/result.h"
#include "planner/machine/machine.h"
#include "planner/machine/machine_keys.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace furrow {

/// Reads a machine: one flat JSON object with keys of machineKeys(). Missing keys keep their defaults.
/// operating_width_m is required. A trailed implement can reverse only if the file says so.
///
/// @param origin  source of the text, for messages; its file name names a machine without a name
/// @return InputRefused, with the place: not JSON (line and column), not an object, an unknown key (naming
/// the nearest one) or one given twice, a value of another kind, and everything that Machine::create refuses.
Result<Machine> parseMachine(std::string_view json, std::string_view origin);

/// The same from a file. ReadFailed: missing or not readable.
Result<Machine> readMachineFile(const std::filesystem::path& path);

/// The machine as text. parseMachine reads it back, equal to the last bit. Ends with a line break.
std::string machineJson(const MachineSpec& spec);

}  // namespace furrow
