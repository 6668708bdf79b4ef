#pragma once

#include "planner/units/quantity.h"

namespace furrow {

/// Into [0, 2 pi).
Angle normalisedPoseHeading(Angle heading);

/// Into [0, pi): a line has no front.
Angle normalisedSwathHeading(Angle heading);

/// Signed difference `to - from` of two pose headings, in (-pi, pi].
Angle headingDifference(Angle from, Angle to);

/// Into [-pi, pi]; an angle that is there already stays as it is, to the last bit.
Angle wrappedAngle(Angle angle);

/// Between two lines, in [0, pi / 2].
Angle angleBetweenLines(Angle a, Angle b);

/// What people see for a line: degrees clockwise from north, in [0, 180).
double lineBearingDeg(Angle swathHeading);
/// The same for a direction, in [0, 360).
double bearingDeg(Angle heading);

}  // namespace furrow
