#pragma once

#include "planner/settings/parameter.h"

namespace furrow {

/// What everything keeps from the boundary.
extern const Parameter kMargin;
/// How far implements may stand over every edge and obstacle, at least.
extern const Parameter kOverhang;
/// Whether connections are checked against the drivable area.
extern const Parameter kStayInside;
/// Whether other plans are driven beside the first one, even if it can be driven.
extern const Parameter kCompare;
/// Choice of this setting: only where the plan as asked cannot be driven.
inline constexpr std::string_view kCompareBlocked = "blocked";

}  // namespace furrow
