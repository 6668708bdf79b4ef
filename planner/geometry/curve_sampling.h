#pragma once

#include "planner/geometry/curve.h"
#include "planner/geometry/polygon.h"

#include <vector>

namespace furrow {

/// Largest distance between a curve and the chords between its samples.
inline constexpr Length kChordTolerance = metres(0.005);

struct CurveSample {
    Length way;  ///< driven since the start of the turn
    Pose pose;
    Curvature curvature;        ///< here; at a jump, of the piece that begins
    Gear gear = Gear::Forward;  ///< of the piece that begins here
    Curvature arriving;         ///< of the piece that ends here; differs only at a jump of curvature
};

/// Samples from the start to the end of a turn, at every change of piece and close enough in between. At
/// least two. Cost: O(samples).
std::vector<CurveSample> sampled(const Curve& turn, Length chordTolerance);

/// A shape around the reference point with the nose to +x, moved to a pose.
Ring placed(const Ring& shape, const Pose& pose);

}  // namespace furrow
