#pragma once

#include "planner/geometry/point.h"
#include "planner/units/quantity.h"

namespace furrow {

/// Heading of a trailed axle after its hitch has moved along a straight line.
///
/// The axle stays `trailing` behind the hitch and does not slip sideways, so its track is a tractrix. The
/// angle b between implement and pull obeys tan(b1/2) = tan(b0/2) exp(-way/trailing). This is exact, also for
/// pushing backwards.
///
/// @param heading   from the axle to the hitch, before
/// @param move      of the hitch
/// @param trailing  from hitch to axle, positive
Angle trailedHeading(Angle heading, Point move, Length trailing);

}  // namespace furrow
