#pragma once

#include "planner/geometry/polygon.h"
#include "planner/path/path_builder.h"

#include <vector>

namespace furrow {

/// Legs of which some are driven with the implement up in between.
struct LiftedLegs {
    std::vector<Leg> legs;
    MultiPolygon passedOver;  ///< what would have been worked there: lanes of the operating width, may overlap
};

/// Cuts legs with the implement down where any part of its working line would lie over land that is driven on and not
/// worked; there the implement is up. Stretches of work that are shorter than `shortest` in between are not worked
/// either. A trailed implement is taken to be in line.
///
/// @param unworked  in metres, may overlap
/// Ends to a centimetre; what is narrower than a quarter of a metre along the way may be missed. Cost: four looks for
/// each metre of a leg near such land.
LiftedLegs liftedOver(const std::vector<Leg>& legs, const MultiPolygon& unworked, const Machine& machine, Length shortest);

}  // namespace furrow
