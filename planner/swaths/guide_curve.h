#pragma once

#include "planner/core/result.h"
#include "planner/swaths/guide_line.h"

#include <string_view>

namespace furrow {

/// What a machine can follow of a line that was drawn or recorded: within 15 cm of it where it bends gently, rounded
/// with the radius where it bends more sharply; drawn out straight at both ends by `reach`, or as far as it does not
/// meet itself.
///
/// @param points  in metres; points that are less than a centimetre apart count once
/// @param where   the setting that it comes from, for errors
/// @return without corners. Usage: fewer than two points that differ. InputRefused: it crosses itself, or turns back
///         on itself more sharply than can be rounded.
Result<GuideLine> guideCurve(const Polyline& points, Length radius, Length reach, std::string_view where);

/// Without drawing it out: a line that ends where it ends, in one or more stretches where it turns back sharply. None
/// of fewer than two points that differ.
std::vector<GuideLine> followedLine(const Polyline& points, Length radius);

}  // namespace furrow
