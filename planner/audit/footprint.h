#pragma once

#include "planner/audit/length.h"
#include "planner/machine/machine.h"

namespace furrow {

/// A rectangle of the machine.
struct FootprintPart {
    double offsetM = 0.0;  ///< of its middle, ahead of its carrier
    double halfLengthM = 0.0;
    double halfWidthM = 0.0;

    double radius() const { return lengthOf({halfLengthM, halfWidthM}); }
};

/// The carrier of the tractor is its own reference point. That of the implement is the middle of its working
/// line.
struct Footprint {
    FootprintPart tractor;
    FootprintPart raised;
    FootprintPart lowered;
    FootprintPart folded;  ///< for transport
    FootprintPart wheels;  ///< of a trailed implement: no broader than the tractor
};

Footprint footprintOf(const Machine& machine);

}  // namespace furrow
