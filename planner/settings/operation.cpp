#include "planner/settings/operation.h"

#include <algorithm>
#include <array>

namespace furrow {

namespace {

// A headland on which the machine turned while it worked the mainland is worked last where the wheels would
// spoil it (sowing); first where it has to be opened or where its inner edge shows where to stop (the
// others). Crop and seed in the mainland are not driven over on the way; soil that is being worked may be.
using Defaults = std::array<OperationDefault, 3>;

Defaults defaults(std::string_view when, std::string_view traversal, double overlapM) {
    return {{{.key = "headland.when", .value = std::string{when}},
             {.key = "route.traversal", .value = std::string{traversal}},
             {.key = "swaths.overlap_m", .value = overlapM}}};
}

// What cuts overlaps a little, so that no strip is left standing where steering is a hand's breadth off.
std::span<const Operation> operations() {
    static const Defaults tillage = defaults("before", "interior", 0.0);
    static const Defaults sowing = defaults("after", "headland", 0.0);
    static const Defaults spraying = defaults("before", "headland", 0.0);
    static const Defaults spreading = defaults("before", "headland", 0.0);
    static const Defaults mowing = defaults("before", "headland", 0.1);
    static const Defaults harvest = defaults("before", "headland", 0.1);
    static const std::array<Operation, 6> all{{{"tillage", TankUse::None, tillage},
                                               {"sowing", TankUse::Empties, sowing},
                                               {"spraying", TankUse::Empties, spraying},
                                               {"spreading", TankUse::Empties, spreading},
                                               {"mowing", TankUse::None, mowing},
                                               {"harvest", TankUse::Fills, harvest}}};
    return all;
}

constexpr Choice kKinds[] = {
    {"tillage", "Tillage", "Working the soil: worked land may be driven over."},
    {"sowing", "Sowing", "Drilling or planting: headland last, ways along the headland."},
    {"spraying", "Spraying", "Crop protection: headland first, ways along the headland."},
    {"spreading", "Spreading", "Fertiliser or manure: headland first, ways along the headland."},
    {"mowing", "Mowing", "Cutting grass: headland first, swaths overlap a little."},
    {"harvest", "Harvest", "Bringing the crop in: headland first, swaths overlap a little."},
};

}  // namespace

const Operation& operationOf(std::string_view id) {
    return *std::ranges::find(operations(), id, &Operation::id);
}

bool isSetByOperation(std::string_view key) {
    return std::ranges::contains(operations().front().defaults, key, &OperationDefault::key);
}

std::string_view tankUseId(TankUse use) {
    switch (use) {
        case TankUse::None: return "none";
        case TankUse::Empties: return "empties";
        case TankUse::Fills: return "fills";
    }
    return "";
}

const Parameter kOperationKind{
    .key = "operation.kind",
    .name = "Operation",
    .description = "What the field is driven over for: sets when the headland is worked, ways and overlap.",
    .kind = ParameterKind::Choice,
    .standard = 0.0,
    .choices = kKinds};

}  // namespace furrow
