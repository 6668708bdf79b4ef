#pragma once

#include "planner/turns/turn.h"

namespace furrow {

// Lines of straights and arcs in forward gear, in which nothing bends more sharply than the offsets asked for.

/// From `from` to `to` along the line, both within its length; pieces of no length are left out.
Turn partOf(const Turn& line, Length from, Length to);

/// The parallel line this far to the left (negative: to the right). Precondition: no arc to that side has a smaller
/// radius.
Turn movedLeft(const Turn& line, Length left);

/// With straight stretches before and after it.
Turn extended(const Turn& line, Length before, Length after);

/// Its sharpest bend, not negative.
Curvature sharpestBend(const Turn& line);

}  // namespace furrow
