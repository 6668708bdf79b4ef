#pragma once

#include "planner/plan/plan.h"

namespace furrow {

/// Says of what blocks a plan, and of which nothing is said yet, what of the settings or the field it comes
/// from. What is known to mend it is advice, which comes later and takes its place.
void addReasons(Plan& plan);

}  // namespace furrow
