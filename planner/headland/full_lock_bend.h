#pragma once

#include "planner/geometry/polygon.h"
#include "planner/machine/machine.h"
#include "planner/turns/rig.h"
#include "planner/turns/trailer.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

/// The line on which an implement works, from its right end to its left end.
using WorkingLine = std::pair<Point, Point>;

/// @param trailer  of the machine; none for a mounted implement
WorkingLine workingLine(const RigState& state, const Machine& machine, const std::optional<Trailer>& trailer);

/// A bend on full lock: the machine enters it in line and drives round one middle. It is driven once, round
/// the origin and from the side of the x-axis. All other bends are this one, turned and moved.
class FullLockBend {
public:
    /// @param side    positive for a bend to the left
    /// @param rounds  that it goes on for
    /// @param look    between two states
    /// Cost: that of following the trailer once.
    FullLockBend(const Rig& lowered, double side, double rounds, Length look);

    std::size_t stateCount() const { return states_.size(); }
    Length wayTo(std::size_t state) const { return static_cast<double>(state) * step_; }
    Curvature curvature() const { return curvature_; }

    /// A state of the bend round another middle that is entered at an angle from it.
    RigState stateAt(std::size_t state, Point middle, Angle begin) const;

    /// The first state by which the implement has passed over a place; none where it does not.
    /// @param place  seen from the middle, with the x-axis towards the begin
    /// Cost: constant.
    std::optional<std::size_t> firstOver(Point place) const;

private:
    /// What the implement sweeps between two states.
    using Strip = std::array<Point, 4>;

    void enterStrips();
    std::size_t columnOf(double x) const { return static_cast<std::size_t>((x - box_.min.x) / kCellM); }
    std::size_t rowOf(double y) const { return static_cast<std::size_t>((y - box_.min.y) / kCellM); }

    static constexpr double kCellM = 1.0;

    std::vector<RigState> states_;
    std::vector<Strip> strips_;  ///< up to the state of the same index; nothing at the first
    Length step_;
    Curvature curvature_;
    // A grid over all strips. Each cell lists those that touch it, in the order of the way.
    Bounds box_;
    std::size_t columns_ = 0;
    std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace furrow
