#pragma once

#include "planner/geometry/polygon.h"
#include "planner/path/path_builder.h"

#include <vector>

namespace furrow {

/// Legs, some of them split by parts with the implement up.
struct LiftedLegs {
    std::vector<Leg> legs;
    MultiPolygon passedOver;  ///< lanes of the operating width that are not worked there; may overlap
};

/// Cuts legs with the implement down at land that is driven on and not worked. The implement is up where any
/// part of its working line would lie over such land. Stretches of work in between that are shorter than
/// `shortest` are not worked either. A trailed implement is assumed to be in line.
///
/// @param unworked  in metres, may overlap
/// Ends are exact to a centimetre. Land narrower than a quarter of a metre along the way may be missed. Cost:
/// four tests for each metre of a leg near such land.
LiftedLegs liftedOver(const std::vector<Leg>& legs, const MultiPolygon& unworked, const Machine& machine,
                      Length shortest);

}  // namespace furrow
