#pragma once

#include "planner/settings/parameter.h"

namespace furrow {

/// What everything keeps from the boundary.
extern const Parameter kMargin;
/// Whether connections are checked against the drivable area.
extern const Parameter kStayInside;

}  // namespace furrow
