#pragma once

#include "planner/core/message.h"
#include "planner/units/quantity.h"

namespace furrow {

/// How long something takes, as one says it: "45 s", "3 min", "2 h 5 min"; without its sign.
Message timeMessage(Duration time);

}  // namespace furrow
