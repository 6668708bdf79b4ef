#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/curve.h"
#include "planner/machine/machine.h"
#include "planner/turns/allowed_edges.h"
#include "planner/turns/footprint_check.h"
#include "planner/turns/rig_parts.h"
#include "planner/turns/trailer.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

namespace furrow {

/// The place of tractor and implement. A mounted implement has the heading of the tractor.
struct RigState {
    Pose tractor;
    Angle implement;

    friend bool operator==(const RigState&, const RigState&) = default;
};

/// Tractor and implement, each in its own area. A trailed implement follows its hitch on its own track (a
/// tractrix). Immutable; thread-safe.
class Rig {
public:
    Rig(const AllowedAreas& areas, const Machine& machine, ImplementAt implement = ImplementAt::Raised);

    const Machine& machine() const { return machine_; }
    /// The same with room for steering in its turns.
    const Machine& steeredMachine() const { return steered_; }
    /// In line, as after a straight stretch.
    static RigState inLine(const Pose& pose) { return {pose, pose.heading}; }

    /// The distance that either is outside at this place; 0 inside. About 1 microsecond near an edge.
    double outsideM(const RigState& state) const { return std::max(0.0, -roomM(state)); }
    /// The least distance that every point of both may move before it is outside. Negative if they are
    /// outside.
    double roomM(const RigState& state) const;

    /// @param noLessM  where the least is below this, some value below it is returned: quicker
    FootprintRoom roomAt(const RigState& state,
                         double noLessM = -std::numeric_limits<double>::infinity()) const;

    /// The state after a piece of a turn. Empty as soon as something is outside. The sampling depends on the
    /// room; an excess between two samples is at most a millimetre or two.
    /// @param touching  a smaller excess does not count
    /// @param known     the room at `from`, if already computed
    std::optional<RigState> driven(const RigState& from, const CurvePiece& piece,
                                   Length touching = metres(1e-3), FootprintRoom known = {}) const;
    /// The state after all of a turn.
    std::optional<RigState> driven(const RigState& from, const Curve& turn, FootprintRoom known = {}) const;

    /// Follows a piece of a turn and visits the state after every `step` and at its end. Empty as soon as
    /// `visit` returns false.
    std::optional<RigState> follow(const RigState& from, const CurvePiece& piece, Length step,
                                   const std::function<bool(const RigState&)>& visit) const;

    /// Whether the machine stays inside while it turns on the spot. Not for a trailed implement, which does
    /// not turn with its tractor.
    bool mayTurnOnTheSpot(const Pose& from, Angle turn) const;

    bool hasTrailer() const { return trailer_.has_value(); }

    /// A place for the tractor's middle where at least its wheels are inside, for every heading.
    /// @param clearance  of its middle, if that is larger
    bool mayStandAt(Point point, Length clearance = {}) const;

private:
    /// A rectangle or T around the point that carries it.
    struct Part {
        Ring shape;
        double radiusM = 0.0;
        Bounds box;  ///< around it
        bool isTrailed = false;
        bool mayOverhang = false;
    };
    static std::vector<Part> partsOf(const Machine& machine, ImplementAt implement, bool overhangs);
    /// The largest radius of the parts that the tractor or the hitch carries.
    double radiusM(bool isTrailed) const;
    const BoundaryDistance& edgesFor(const Part& part) const {
        return part.mayOverhang ? edges_.implement() : edges_.tractor();
    }
    Pose poseOf(const Part& part, const RigState& state) const {
        return part.isTrailed ? trailer_->poseOf(state.tractor, state.implement) : state.tractor;
    }
    /// The longest steps in which a trailed implement is followed over a piece whose curvature changes. Empty
    /// where its place follows from the whole way at once.
    std::optional<Length> stepsFor(const CurvePiece& piece) const {
        return trailer_ && piece.curvature != piece.endCurvature ? std::optional{trailer_->longestStep()}
                                                                 : std::nullopt;
    }
    /// The state after a part of a piece.
    /// @param from  at the begin of the piece
    /// @param last  one step before, where there are steps
    RigState stateAfter(const RigState& from, const RigState& last, const CurvePiece& piece,
                        Length way) const;
    /// Whether the end of a piece is outside: a quick look before the whole turn is followed. Looks no
    /// farther than the first piece whose end takes steps.
    bool isOutsideAtAnEnd(RigState state, const Curve& turn) const;
    FootprintRoom roomAround(const Part& part, const Pose& pose, double noLessM) const;
    /// Whether a part is known to stay inside if it goes straight on, or back if `wayM` is negative.
    bool isClearAhead(const Part& part, const Pose& pose, double wayM, double touchingM) const;
    bool isClearAhead(const RigState& state, double wayM, double touchingM) const;
    /// @param room  at `from`, then at the end; never more than the real room
    std::optional<RigState> drivenOn(const RigState& from, const CurvePiece& piece, Length touching,
                                     FootprintRoom& room) const;
    /// The depth of the field's edges in a part, or in all parts.
    double crossedM(const Part& part, const Pose& pose) const;
    double crossedM(const RigState& state) const;

    Machine machine_;
    Machine steered_;
    std::optional<Trailer> trailer_;
    std::vector<Part> parts_;
    double tractorRadiusM_;  ///< of what the tractor carries
    double trailedRadiusM_;  ///< of what the hitch carries
    AllowedEdges edges_;
};

}  // namespace furrow
