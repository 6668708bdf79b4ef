#pragma once

#include "planner/geometry/point.h"
#include "planner/units/quantity.h"

namespace furrow {

/// Where the reference point is and where the nose points.
struct Pose {
    Point position;
    Angle heading;

    friend bool operator==(const Pose&, const Pose&) = default;
};

}  // namespace furrow
