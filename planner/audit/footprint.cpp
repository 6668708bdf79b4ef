#include "planner/audit/footprint.h"

namespace furrow {

Footprint footprintOf(const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    const Implement& implement = machine.spec().implement;
    const double halfLength = 0.5 * implement.length.si();
    return {.tractor = {.offsetM = (0.5 * tractor.length - tractor.rearOverhang).si(),
                        .halfLengthM = 0.5 * tractor.length.si(),
                        .halfWidthM = 0.5 * tractor.width.si()},
            .raised = {.halfLengthM = halfLength,
                       .halfWidthM = 0.5 * implement.raisedWidth.value_or(implement.operatingWidth).si()},
            .lowered = {.halfLengthM = halfLength, .halfWidthM = 0.5 * implement.operatingWidth.si()}};
}

}  // namespace furrow
