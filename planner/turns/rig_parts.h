#pragma once

#include "planner/geometry/polygon.h"
#include "planner/machine/machine.h"

#include <vector>

namespace furrow {

enum class ImplementAt { Raised, Lowered };

/// A part of a machine that keeps its shape.
struct RigPart {
    Ring shape;                ///< around the point that carries it, nose to +x
    bool isTrailed = false;    ///< carried by the hitch, otherwise by the tractor's reference point
    bool mayOverhang = false;  ///< in the area for the implement, otherwise in that for the tractor
};

/// The parts of a machine, the tractor's first: one if the implement is mounted, otherwise two.
/// @param overhangs  implement and tractor have different areas. The tractor is then a part of its own, and
/// so
///                   are the wheels of a trailed implement: a box as wide as the tractor.
std::vector<RigPart> rigParts(const Machine& machine, ImplementAt implement, bool overhangs);

/// How far a machine reaches from the place about which it turns on the spot.
struct TurningReach {
    Length tractor;
    Length whole;  ///< with its raised implement
};

TurningReach turningReach(const Machine& machine);

}  // namespace furrow
