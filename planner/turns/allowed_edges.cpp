#include "planner/turns/allowed_edges.h"

#include "planner/turns/footprint_check.h"
#include "planner/turns/trailer.h"

#include <utility>

namespace furrow {

AllowedEdges::AllowedEdges(const AllowedAreas& areas, Length reach) : tractor_{areas.tractor(), reach} {
    if (areas.hasOverhang()) {
        implement_.emplace(areas.implement(), reach);
    }
}

RigidRoom::RigidRoom(const AllowedAreas& areas, const Machine& machine, Ring footprint, Length reach)
    : edges_{areas, reach}, footprint_{std::move(footprint)}, tractor_{tractorOutline(machine)} {}

bool RigidRoom::isInside(const Pose& pose) const {
    return furrow::isInside(pose, footprint_, edges_.implement()) &&
           (!edges_.hasOverhang() || furrow::isInside(pose, tractor_, edges_.tractor()));
}

bool RigidRoom::staysInside(const Curve& turn, Length step) const {
    return furrow::staysInside(turn, footprint_, edges_.implement(), step) &&
           (!edges_.hasOverhang() || furrow::staysInside(turn, tractor_, edges_.tractor(), step));
}

}  // namespace furrow
