#pragma once

#include "planner/core/result.h"
#include "planner/swaths/guide_line.h"

#include <string_view>

namespace furrow {

/// The part of a drawn or recorded line that a machine can follow. Gentle bends stay within 15 cm of the
/// line; sharper bends are rounded with the radius. Both ends are extended straight by `reach`, or less if
/// the line would meet itself.
///
/// @param points  in metres; points less than a centimetre apart count as one
/// @param where   the setting with the line, for errors
/// @return without corners. Usage: fewer than two different points. InputRefused: the line crosses itself, or
/// turns back more sharply than can be rounded.
Result<GuideLine> guideCurve(const Polyline& points, Length radius, Length reach, std::string_view where);

/// The same without extended ends. A line that turns back sharply gives several stretches. Empty for fewer
/// than two different points.
std::vector<GuideLine> followedLine(const Polyline& points, Length radius);

}  // namespace furrow
