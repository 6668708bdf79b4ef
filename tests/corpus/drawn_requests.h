#pragma once

#include "planner/field/field.h"
#include "planner/machine/machine.h"
#include "planner/settings/settings.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace furrow::test {

/// Small ones are no wider than 50 m, with few parts and holes: a second for each.
enum class DrawnSize { Any, Small };

/// A field, a machine and settings that nobody chose, with what was refused while they were put together.
struct DrawnRequest {
    FieldSource field;
    MachineSpec machine;
    Settings settings;
    std::string told;  ///< kind of field, machine and settings in one line, for whoever looks at a failure

    /// Errors of settings that were left out.
    std::vector<Error> refused;
};

/// The same seed draws the same on every computer. Fields of 3 to 1,500 m: convex, with bays, holes, stars,
/// combs and strips, in one part or several; two of five damaged: points repeated or almost, spikes,
/// slivers, holes that touch each other or the boundary, crossings, points moved to others. Obstacles and
/// gates beside. Half of the machines are of the library, others have some values anywhere in the ranges of
/// machine_keys.h. Settings: none, some or many of the method registry, within their ranges; text ones with
/// lines, places and numbers about the field.
DrawnRequest drawnRequest(std::uint64_t seed, DrawnSize size = DrawnSize::Any);

/// A small one that bytes choose: the first eight are a seed, which settles the outlines; then two settle
/// each choice, one after the other. Where they end the seed goes on. Plans are compared for every sixteenth
/// seed only: twenty plans of one field find little more than one does.
DrawnRequest chosenRequest(std::span<const std::uint8_t> bytes);

}  // namespace furrow::test
