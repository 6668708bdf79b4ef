#pragma once

#include "planner/geometry/curve.h"
#include "planner/geometry/polygon.h"
#include "planner/machine/machine.h"

#include <optional>

namespace furrow {

/// A trailed implement: it follows its hitch on its own track (a tractrix).
struct Trailer {
    double hitchM = 0.0;     ///< from the tractor's fixed axle, negative behind it
    double trailingM = 0.0;  ///< from the hitch to the working line
    Ring raised;             ///< its outline with the hitch at the origin, drawbar to +x
    Ring lowered;
    Ring wheels;  ///< a box as long as the implement, as wide as the tractor or the narrower implement

    /// Empty if the implement is mounted, or so close behind its hitch that it swings with the tractor.
    static std::optional<Trailer> of(const Machine& machine);

    Pose poseOf(const Pose& tractor, Angle heading) const;
    /// The heading of the implement after a move of the tractor, with the hitch assumed to move straight.
    /// Within a millimetre of the track for steps of `longestStep`.
    Angle headingAfter(Angle heading, const Pose& from, const Pose& to) const;
    /// The same after the tractor has driven a way with one curvature, however long. Exact.
    /// @param from  heading of the tractor before
    /// @param way   negative in reverse
    Angle headingAfter(Angle heading, Angle from, Curvature curvature, Length way) const;
    Length longestStep() const;
};

/// The outline of the tractor only, counter-clockwise, reference point at the origin.
Ring tractorOutline(const Machine& machine);

}  // namespace furrow
