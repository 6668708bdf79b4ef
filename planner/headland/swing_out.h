#pragma once

#include "planner/turns/rig.h"

namespace furrow {

/// A closed line whose tight corners are driven so that a trailed implement gets farther into them: the tractor turns
/// later and by more than the corner, and comes back to its line from outside; the implement, which cuts the corner on
/// its own track, is held back by that. As much as there is room for, corner by corner; the rest stays as it is. Ends
/// meet as before. Cost: some looks at the rig for each corner.
Turn swungOut(const Turn& line, const Rig& rig);

}  // namespace furrow
