#pragma once

#include "planner/geometry/boundary_distance.h"
#include "planner/machine/machine.h"
#include "planner/turns/footprint_check.h"
#include "planner/turns/trailer.h"
#include "planner/turns/turn.h"

#include <algorithm>
#include <functional>
#include <optional>

namespace furrow {

/// Where tractor and implement are. A mounted implement points where the tractor does.
struct RigState {
    Pose tractor;
    Angle implement;

    friend bool operator==(const RigState&, const RigState&) = default;
};

enum class ImplementAt { Raised, Lowered };

/// Tractor and implement in a bounded space. A trailed implement follows its hitch on its own track (a tractrix).
/// Immutable; may be asked by several threads at once.
class Rig {
public:
    /// @param drivable  where both may be
    Rig(const MultiPolygon& drivable, const Machine& machine, ImplementAt implement = ImplementAt::Raised);

    const Machine& machine() const { return machine_; }
    /// In line, as after a straight stretch.
    static RigState inLine(const Pose& pose) { return {pose, pose.heading}; }

    /// How far either gets outside at this place; 0 inside. About 1 microsecond near an edge.
    double outsideM(const RigState& state) const { return std::max(0.0, -roomM(state)); }
    /// How far every point of both may move at least without getting outside; less than 0 by how far they are.
    double roomM(const RigState& state) const;

    FootprintRoom roomAt(const RigState& state) const;

    /// After a piece of a turn; nothing as soon as something is outside. It is looked at as often as the room there is
    /// asks for: what is outside in between is so by a millimetre or two.
    /// @param touching  outside by less is none
    /// @param known     the room at `from`, where somebody has asked for it
    std::optional<RigState> driven(const RigState& from, const TurnPiece& piece, Length touching = metres(1e-3),
                                   FootprintRoom known = {}) const;
    /// After all of a turn.
    std::optional<RigState> driven(const RigState& from, const Turn& turn, FootprintRoom known = {}) const;

    /// Along a piece of a turn, with the state after every `step` and at its end; until `visit` says no, then nothing.
    std::optional<RigState> follow(const RigState& from, const TurnPiece& piece, Length step,
                                   const std::function<bool(const RigState&)>& visit) const;

    bool hasTrailer() const { return trailer_.has_value(); }

    /// A place for the tractor's middle where at least its wheels are inside, whichever way it points.
    /// @param clearance  of its middle, where that is more
    bool mayStandAt(Point point, Length clearance = {}) const;

private:
    /// A rectangle or T around what carries it.
    struct Part {
        Ring shape;
        double radiusM = 0.0;
        Bounds box;  ///< around it
    };
    static Part partOf(Ring shape);
    FootprintRoom roomAround(const Part& part, const Pose& pose) const;
    /// Whether a part is known to stay inside when it goes straight on, or back by a way less than 0.
    bool isClearAhead(const Part& part, const Pose& pose, double wayM, double touchingM) const;
    bool isClearAhead(const RigState& state, double wayM, double touchingM) const;
    /// @param room  at `from`, then at the end, or less than there is
    std::optional<RigState> drivenOn(const RigState& from, const TurnPiece& piece, Length touching, FootprintRoom& room) const;
    /// How deep edges of the field lie in a part, or in both.
    double crossedM(const Part& part, const Pose& pose) const;
    double crossedM(const RigState& state) const;

    Machine machine_;
    std::optional<Trailer> trailer_;
    Part tractor_;  ///< with the implement where that is mounted
    Part trailed_;  ///< its hitch at the origin
    BoundaryDistance edges_;
};

}  // namespace furrow
