#pragma once

#include "planner/route/route.h"
#include "planner/settings/method.h"

namespace furrow {

/// Which of a pattern's four corners the route starts at.
extern const Parameter kCorner;

extern const Method<RoutePlanner> kBoustrophedonMethod;

}  // namespace furrow
