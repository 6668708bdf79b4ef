#pragma once

#include "planner/settings/parameter.h"

namespace furrow {

/// What the field is driven over for.
extern const Parameter kOperationKind;
/// What everything keeps from the boundary.
extern const Parameter kMargin;
/// Whether connections are checked against the drivable area.
extern const Parameter kStayInside;

}  // namespace furrow
