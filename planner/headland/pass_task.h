#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/geometry/polygon.h"
#include "planner/machine/machine.h"
#include "planner/settings/settings.h"

namespace furrow {

/// The inputs of headland passes. The passes keep none of them. They run with the field on their left.
struct PassTask {
    const MultiPolygon& workable;  ///< the field that they go round
    const AllowedAreas& drivable;
    const Machine& machine;
    const Settings& settings;
    Length margin = {};  ///< distance that everything keeps from the boundary
};

}  // namespace furrow
