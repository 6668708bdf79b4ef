#pragma once

#include "planner/geometry/polygon.h"
#include "planner/machine/machine.h"
#include "planner/settings/settings.h"

namespace furrow {

/// What headland passes are laid from; nothing of it is kept. They run with the field on their left.
struct PassTask {
    const MultiPolygon& workable;  ///< the field that they go round
    const MultiPolygon& drivable;  ///< where tractor and implement may be
    const Machine& machine;
    const Settings& settings;
    Length margin = {};  ///< what everything keeps from the boundary
};

}  // namespace furrow
