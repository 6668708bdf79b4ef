#pragma once

#include "planner/turns/rig.h"

namespace furrow {

/// A closed line whose tight corners are changed so that a trailed implement reaches farther into them. The
/// tractor turns later and further than the corner, and returns to its line from outside. This holds the
/// implement back, which cuts the corner on its own track. Each corner gets the largest swing that has room.
/// The other parts stay unchanged, and the ends still meet. Cost: some checks of the rig for each corner.
Curve swungOut(const Curve& line, const Rig& rig);

}  // namespace furrow
