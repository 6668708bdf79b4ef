#pragma once

#include "planner/geometry/boundary_distance.h"
#include "planner/machine/machine.h"
#include "planner/turns/turn.h"

#include <optional>
#include <vector>

namespace furrow {

/// Where tractor and implement are. A mounted implement points where the tractor does.
struct RigState {
    Pose tractor;
    Angle implement;

    friend bool operator==(const RigState&, const RigState&) = default;
};

/// Tractor and implement in a bounded space. A trailed implement follows its hitch on its own track (a tractrix).
/// Immutable; may be asked by several threads at once.
class Rig {
public:
    /// @param drivable  where both may be
    Rig(const MultiPolygon& drivable, const Machine& machine);

    const Machine& machine() const { return machine_; }
    /// In line, as after a straight stretch.
    static RigState inLine(const Pose& pose) { return {pose, pose.heading}; }

    /// How far either gets outside at this place, implement up; 0 inside. About 1 microsecond near an edge.
    double outsideM(const RigState& state) const;

    /// After a piece of a turn; nothing as soon as something is outside, asked every `step`.
    std::optional<RigState> driven(const RigState& from, const TurnPiece& piece, Length step) const;
    /// After all of a turn.
    std::optional<RigState> driven(const RigState& from, const Turn& turn, Length step) const;

    bool hasTrailer() const { return trailed_.has_value(); }

    /// A place for the tractor's middle where at least its wheels are inside, whichever way it points.
    bool mayStandAt(Point point) const;

private:
    /// A rectangle or T around what carries it.
    struct Part {
        Ring shape;
        double radiusM = 0.0;
    };
    static Part partOf(Ring shape);
    double outsideM(const Part& part, const Pose& pose) const;
    /// Along one piece, until `visit` says no.
    template <class Visit>
    std::optional<RigState> follow(const RigState& from, const TurnPiece& piece, Length step, const Visit& visit) const;

    Machine machine_;
    Part tractor_;  ///< with the implement where that is mounted
    std::optional<Part> trailed_;  ///< its hitch at the origin
    double hitchM_ = 0.0;
    double trailingM_ = 0.0;  ///< from the hitch to the working line
    BoundaryDistance edges_;
};

}  // namespace furrow
