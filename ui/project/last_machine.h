#pragma once

#include "planner/project/project.h"

namespace furrow {

/// Remembers the machine that was chosen last and what it does, for the next project.
void rememberMachine(const Machine& machine, const Settings& settings);

/// An empty project that begins with the machine that was chosen last, otherwise with the library's first.
Project freshProject();

}  // namespace furrow
