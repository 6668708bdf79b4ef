#pragma once

#include "planner/machine/machine.h"
#include "planner/path/path_builder.h"

#include <span>

namespace furrow {

enum class SteeringLimit { Kept, Ignored };

/// The path over joined legs: the fastest drive within the limits for work, turns, reversing, steering,
/// sideways and lengthwise acceleration, from one pass forwards (acceleration) and one backwards (braking).
/// Source of the two passes: Shin & McKay 1985, doi 10.1109/TAC.1985.1104009.
///
/// @return segments in driving order, sampled at every change of curvature. Chords between samples stay
/// within 5 mm of the curve. Position is continuous; heading too, unless the turns are `straight`.
/// Speed starts and ends at 0 and stops where gear or heading change, or where the curvature jumps and the
/// machine has to steer. It also stands where a folded stretch begins and ends, for the time to fold, and at
/// refill points, for the time to fill: the next segment begins there that much later. A turn lasts at least
/// until the implement is lifted and lowered. Between two samples the acceleration is constant. Cost:
/// O(samples).
/// @param steering  ignored: as if the wheels turned at once
Path withSpeeds(std::span<const Leg> legs, const Machine& machine,
                SteeringLimit steering = SteeringLimit::Kept);

}  // namespace furrow
