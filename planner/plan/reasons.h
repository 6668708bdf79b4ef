#pragma once

#include "planner/plan/plan.h"

namespace furrow {

/// Adds the cause to each blocking finding that names none: a setting, or the shape of the field. Advice,
/// which is added later, replaces it.
void addReasons(Plan& plan);

}  // namespace furrow
