#pragma once

#include "planner/audit/length.h"
#include "planner/machine/machine.h"

namespace furrow {

/// A rectangle of the machine.
struct FootprintPart {
    double offsetM = 0.0;  ///< of its middle, ahead of what carries it
    double halfLengthM = 0.0;
    double halfWidthM = 0.0;

    double radius() const { return lengthOf({halfLengthM, halfWidthM}); }
};

/// The tractor is carried by its own reference point, the implement by the middle of its working line.
struct Footprint {
    FootprintPart tractor;
    FootprintPart raised;
    FootprintPart lowered;
    FootprintPart folded;  ///< for transport
};

Footprint footprintOf(const Machine& machine);

}  // namespace furrow
