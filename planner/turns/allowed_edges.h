#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/curve.h"
#include "planner/machine/machine.h"

#include <optional>

namespace furrow {

/// The edges that a machine must not cross. Immutable; thread-safe.
class AllowedEdges {
public:
    /// @param reach  largest distance that is measured; > 0
    AllowedEdges(const AllowedAreas& areas, Length reach);

    const BoundaryDistance& tractor() const { return tractor_; }
    const BoundaryDistance& implement() const { return implement_ ? *implement_ : tractor_; }
    bool hasOverhang() const { return implement_.has_value(); }

private:
    BoundaryDistance tractor_;
    std::optional<BoundaryDistance> implement_;
};

/// A machine whose implement counts as rigid, between such edges.
class RigidRoom {
public:
    /// @param footprint  of the machine: the implement at work or raised
    RigidRoom(const AllowedAreas& areas, const Machine& machine, Ring footprint, Length reach);

    /// As isInside and staysInside of a footprint.
    bool isInside(const Pose& pose) const;
    bool staysInside(const Curve& turn, Length step) const;

private:
    AllowedEdges edges_;
    Ring footprint_;
    Ring tractor_;
};

}  // namespace furrow
