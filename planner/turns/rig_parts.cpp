#include "planner/turns/rig_parts.h"

#include "planner/turns/footprint_check.h"
#include "planner/turns/trailer.h"

namespace furrow {

std::vector<RigPart> rigParts(const Machine& machine, ImplementAt implement, bool overhangs) {
    const bool isLowered = implement == ImplementAt::Lowered;
    const auto trailer = Trailer::of(machine);
    std::vector<RigPart> parts;
    if (overhangs || trailer) {
        parts.push_back({.shape = tractorOutline(machine)});
    }
    if (trailer) {
        if (overhangs) {
            parts.push_back({.shape = trailer->wheels, .isTrailed = true});
        }
        parts.push_back({.shape = isLowered ? trailer->lowered : trailer->raised,
                         .isTrailed = true,
                         .mayOverhang = overhangs});
    } else {
        parts.push_back({.shape = isLowered ? machine.workingFootprint() : machine.turningFootprint(),
                         .mayOverhang = overhangs});
    }
    return parts;
}

TurningReach turningReach(const Machine& machine) {
    return {.tractor = metres(radiusOf(tractorOutline(machine))),
            .whole = metres(radiusOf(machine.turningFootprint()))};
}

}  // namespace furrow
