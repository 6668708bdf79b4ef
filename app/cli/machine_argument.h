#pragma once

#include "planner/core/result.h"
#include "planner/machine/machine.h"

#include <string>

namespace furrow::cli {

/// What --machine names: a machine file, a machine of the library by id or name, or its first one where
/// nothing is given.
Result<Machine> machineFrom(const std::string& nameOrFile);

}  // namespace furrow::cli
