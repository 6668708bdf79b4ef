#pragma once

#include "planner/machine/machine.h"
#include "planner/turns/turn.h"

namespace furrow {

/// The common signature of all turn methods: a manoeuvre in free space between two poses. Always succeeds:
/// finite poses and a machine that exists are all it needs. What the machine or the poses do not allow is
/// replaced by another manoeuvre; the turn's type says which.
using TurnPlanner = Turn(const Pose& from, const Pose& to, const Machine& machine);

/// Whether a turn may reverse: the tractor can, and it does not pull what cannot be pushed.
inline bool canReverse(const Machine& machine) {
    const Implement& implement = machine.spec().implement;
    return machine.spec().tractor.canReverse &&
           (implement.mounting != Mounting::Trailed || implement.canReverse);
}

/// What a change of gear costs: braking from the one speed and speeding up to the other.
Duration gearChangeDuration(const Machine& machine);

/// How long a turn takes at the speeds for turning and reversing; of speeding up and braking only what its changes
/// of gear need.
Duration roughDuration(const Turn& turn, const Machine& machine);

}  // namespace furrow
