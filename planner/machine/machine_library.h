#pragma once

#include "planner/core/result.h"
#include "planner/machine/machine.h"

#include <span>
#include <string_view>

namespace furrow {

/// The machines that come with the program, in the order shown to people. The first one is the default. Read
/// once, on first use. Thread-safe.
std::span<const Machine> machineLibrary();

/// The operation that a machine of the library is made for, as in settings: "spraying". Empty for other
/// machines.
std::string_view usualOperation(const Machine& machine);

/// The library's machine with this id or name; case does not matter. Usage: there is none. The message lists
/// the ids and names the nearest one.
Result<Machine> findMachine(std::string_view idOrName);

}  // namespace furrow
