#pragma once

#include "planner/geometry/curve.h"
#include "planner/geometry/eased_line.h"
#include "planner/machine/machine.h"

#include <functional>
#include <span>
#include <vector>

namespace furrow {

/// The way in which the steering gets from straight to full lock at the turning speed. Curvature that changes
/// over such a window can be driven at that speed. Less if an arc on full lock would move by more than 6 cm.
Length steeringWindow(const Machine& machine);

/// A closed line with its curvature averaged over that window, as `steerableLegs` makes it where there is
/// room. It begins in the middle of its longest straight. The line itself if that is not possible.
/// @param stays  pieces that begin and end at such places stay as they are
/// Cost: some ten microseconds for each bend.
Curve steeredRing(const Curve& ring, const Machine& machine, const std::function<bool(Point)>& stays);

/// Where the curvature jumps, with the arcs beside, or changes faster than the steering follows at half the
/// turning speed. In metres from the start of the line.
std::vector<LineRange> jumpsOf(const Curve& line, const Machine& machine);

/// Averaging windows that are changed in parts.
class SteeringWindows {
public:
    /// No windows.
    explicit SteeringWindows(Length line) : endM_{line.si()}, stretches_{{0.0, 0.0}} {}

    /// @param window  outside of the line it counts for nothing
    void set(const LineRange& range, Length window);
    void widen(const LineRange& range, Length window);
    /// The next smaller of some shares of `whole`, then the least window, in the end none.
    void shrink(const LineRange& range, Length whole);
    AveragingWindows windows() const;

private:
    struct Stretch {
        double fromM = 0.0;
        double mostM = 0.0;
    };
    std::span<Stretch> within(const LineRange& range);

    double endM_;
    std::vector<Stretch> stretches_;
};

/// The sharpest bend that the machine can drive, and of eased lines: sharper by 0.01 %.
Curvature fullLock(const Machine& machine);
Curvature sharpestSteered(const Machine& machine);

/// A worked line moves by no more than this to the inside of a bend.
inline constexpr Length kMostAside = metres(0.06);

}  // namespace furrow
