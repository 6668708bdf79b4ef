#pragma once

#include "planner/settings/parameter.h"

namespace furrow {

/// What everything keeps from the boundary.
extern const Parameter kMargin;
/// How far implements may stand over every edge and obstacle, at least.
extern const Parameter kOverhang;
/// Whether connections are checked against the drivable area.
extern const Parameter kStayInside;

}  // namespace furrow
