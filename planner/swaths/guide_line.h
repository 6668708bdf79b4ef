#pragma once

#include "planner/geometry/box_tree.h"
#include "planner/geometry/curve.h"
#include "planner/geometry/polygon.h"

#include <optional>
#include <vector>

namespace furrow {

/// A stretch of a guide line: a straight, an arc, or a corner of no length.
struct GuidePiece {
    double lengthM = 0.0;
    double turnRad = 0.0;  ///< positive to the left
};

/// A line that swaths follow, before or after its corners are rounded.
struct GuideLine {
    Pose start;
    std::vector<GuidePiece> pieces;
};

/// A line through these points, at least two of them different, each a corner. A corner becomes an arc if the
/// edges beside it leave room. The arc has the radius or more and stays within `tolerance` of the corner.
GuideLine guideLineThrough(const Polyline& points, Length radius, Length tolerance);

/// The same line as stretches to drive. Its corners must already be rounded.
Curve drivable(const GuideLine& line);

/// Rounding a sharper bend leaves more than half a width between neighbouring parallels.
inline constexpr Angle kSharpestBend = degrees(100.0);

/// The lines beside a guide line. Immutable; thread-safe.
///
/// A parallel at distance d is the set of places whose nearest point of the guide line is d away. An offset
/// can come closer to the line than d, in swallowtails of bends tighter than d; these parts are cut off.
/// Where the guide line comes back beside itself, the parallels end halfway. The rest is opened
/// morphologically with a disc of the wanted radius, from the far side. Bends on the inside are then arcs of
/// that radius, and two parallels are nowhere closer than the difference of their distances. If that would
/// round a bend of more than `sharpest`, the parallel is cut in two instead. Each part goes as far as the
/// machine can follow it.
///
/// Arcs are exact. The offset at distance d plus radius is sampled for its free stretches (nothing else is
/// closer). Their ends are refined by halving. Two neighbouring stretches meet at the centre of the arc
/// between them. Cost of a parallel: O(n log n) for n pieces and metres.
class ParallelLines {
public:
    explicit ParallelLines(GuideLine line);

    /// The parallel to the left, or to the right if `leftM` is negative, in order along the guide line. Empty
    /// if nothing remains. For 0 the guide line with its left corners rounded, for -0 with its right ones.
    std::vector<GuideLine> at(double leftM, Length radius, Angle sharpest = kSharpestBend) const;

    /// Metres to the left of the nearest point of the line, negative to the right.
    double leftOf(Point point) const;

private:
    struct Interval {
        double from;
        double to;
    };

    struct Placed {
        GuidePiece piece;
        Point from;
        double headingRad = 0.0;
    };

    Pose on(double place, double leftM) const;
    double distanceM(Point point, std::size_t piece) const;
    bool isFree(double place, double leftM) const;
    /// Places from one to another, no farther apart than `apartM`, along the line and beside it.
    std::vector<double> placesBetween(double from, double to, double leftM, double apartM) const;
    std::vector<Interval> freeAmong(const std::vector<double>& places, double leftM) const;
    std::vector<Interval> freeStretches(double leftM) const;
    std::vector<Interval> withoutTight(const std::vector<Interval>& stretches, double leftM,
                                       double radiusM) const;
    void append(GuideLine& line, Interval stretch, double leftM) const;

    GuideLine line_;
    std::vector<Placed> placed_;
    BoxTree tree_;
};

}  // namespace furrow
