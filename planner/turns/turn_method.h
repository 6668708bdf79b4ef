#pragma once

#include "planner/geometry/curve.h"
#include "planner/machine/machine.h"
#include "planner/settings/method.h"

namespace furrow {

/// The common signature of all turn methods: a manoeuvre in free space between two poses. It always succeeds
/// for finite poses and a valid machine. If the machine or the poses do not allow the manoeuvre, another one
/// replaces it; the turn's type says which.
using TurnPlanner = Curve(const Pose& from, const Pose& to, const Machine& machine);

template <>
struct MethodTraits<TurnPlanner> {
    bool isAnyKind = false;   ///< takes whatever kind is quickest and fits
    bool isSmooth = false;    ///< curvature without steps
    bool reverses = false;    ///< may drive backwards
    bool isStanding = false;  ///< turns on the spot
};

/// Whether a turn may reverse: the tractor can, and it does not pull an implement that cannot be pushed.
inline bool canReverse(const Machine& machine) {
    const Implement& implement = machine.spec().implement;
    return machine.spec().tractor.canReverse &&
           (implement.mounting != Mounting::Trailed || implement.canReverse);
}

/// The time for a change of gear: braking from the one speed and accelerating to the other.
Duration gearChangeDuration(const Machine& machine);

/// 8 radii and 4 widths.
Length longestTurn(const Machine& machine);
/// A longer way of several moves, or straight after a turn on the spot, is a transfer.
bool isDrivenAsTransfer(const Curve& way, const Machine& machine);

/// The time of a turn at the speeds for turning and reversing. Acceleration and braking count only at changes
/// of gear and where it turns on the spot on its way.
Duration roughDuration(const Curve& turn, const Machine& machine);

}  // namespace furrow
