#pragma once

#include "planner/settings/parameter.h"

#include <span>
#include <string_view>

namespace furrow {

/// What the field is driven over for.
extern const Parameter kOperationKind;

/// What an operation makes of a setting that is not given.
struct OperationDefault {
    std::string_view key;
    SettingValue value;
};

/// What becomes of a tank or bunker on the way.
enum class TankUse { None, Empties, Fills };

/// One kind of operation and what follows from it. Every operation has defaults for the same settings.
struct Operation {
    std::string_view id;  ///< as in settings: "sowing"
    TankUse tank = TankUse::None;
    std::span<const OperationDefault> defaults;
};

/// The operation of this id, which has to be one of kOperationKind's choices.
const Operation& operationOf(std::string_view id);

/// Whether the default of this setting depends on the operation.
bool isSetByOperation(std::string_view key);

/// "none", "empties", "fills": as in plan files.
std::string_view tankUseId(TankUse use);

}  // namespace furrow
