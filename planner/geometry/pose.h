#pragma once

#include "planner/geometry/point.h"
#include "planner/units/quantity.h"

namespace furrow {

/// The place of the reference point and the heading of the nose.
struct Pose {
    Point position;
    Angle heading;

    friend bool operator==(const Pose&, const Pose&) = default;
};

}  // namespace furrow
