#pragma once

#include "planner/machine/machine.h"
#include "planner/turns/turn.h"

namespace furrow {

/// The common signature of all turn methods: a manoeuvre in free space between two poses. Always succeeds:
/// finite poses and a machine that exists are all it needs.
using TurnPlanner = Turn(const Pose& from, const Pose& to, const Machine& machine);

}  // namespace furrow
