#include "planner/audit/footprint.h"

#include <algorithm>

namespace furrow {

Footprint footprintOf(const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    const Implement& implement = machine.spec().implement;
    const double halfLength = 0.5 * implement.length.si();
    const Length raised = implement.raisedWidth.value_or(implement.operatingWidth);
    return {.tractor = {.offsetM = (0.5 * tractor.length - tractor.rearOverhang).si(),
                        .halfLengthM = 0.5 * tractor.length.si(),
                        .halfWidthM = 0.5 * tractor.width.si()},
            .raised = {.halfLengthM = halfLength, .halfWidthM = 0.5 * raised.si()},
            .lowered = {.halfLengthM = halfLength, .halfWidthM = 0.5 * implement.operatingWidth.si()},
            .folded = {.halfLengthM = halfLength,
                       .halfWidthM = 0.5 * implement.transportWidth.value_or(raised).si()},
            .wheels = {.halfLengthM = halfLength,
                       .halfWidthM = 0.5 * std::min({tractor.width, raised, implement.operatingWidth}).si()}};
}

}  // namespace furrow
