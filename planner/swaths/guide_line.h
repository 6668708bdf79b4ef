#pragma once

#include "planner/geometry/box_tree.h"
#include "planner/geometry/polygon.h"
#include "planner/turns/turn.h"

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

/// Through these points, at least two that differ, each a corner; where the edges beside a corner leave room for an
/// arc of the radius or more that stays within `tolerance` of it, that arc.
GuideLine guideLineThrough(const Polyline& points, Length radius, Length tolerance);

/// The same line as stretches to drive; corners have to be rounded before.
Turn drivable(const GuideLine& line);

/// Rounding more than this leaves more than half a width between one parallel and the next.
inline constexpr Angle kSharpestBend = degrees(100.0);

/// The lines beside a guide line. Immutable; may be asked by several threads at once.
///
/// A parallel at distance d is where the nearest point of the guide line is d away: what an offset draws closer to
/// the line than that, the swallowtails of bends that are tighter than d, is cut off, and where the guide line comes
/// back beside itself the parallels end halfway. Of that, what a disc of the wanted radius reaches from the far side
/// (a morphological opening): bends on the inside are arcs of that radius, and two parallels are nowhere closer to
/// each other than the difference of their distances. Where that would round a bend of more than `sharpest` the
/// parallel is cut in two instead, each as far as the machine can follow it.
///
/// In exact arcs: at the distance d plus radius, the stretches of the offset that nothing else is closer to are found
/// by looking along it and halving; between two of them the centre of the arc is where they meet. Cost of a
/// parallel: O(n log n) for n pieces and metres.
class ParallelLines {
public:
    explicit ParallelLines(GuideLine line);

    /// To the left, or to the right where the distance is negative; in order along the guide line. None where nothing
    /// is left. Of 0 the guide line with its corners to the left (or of -0 to the right) rounded.
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
    /// From one place to another, looked at no farther apart than this along the line and beside it.
    std::vector<double> placesBetween(double from, double to, double leftM, double apartM) const;
    std::vector<Interval> freeAmong(const std::vector<double>& places, double leftM) const;
    std::vector<Interval> freeStretches(double leftM) const;
    std::vector<Interval> withoutTight(const std::vector<Interval>& stretches, double leftM, double radiusM) const;
    void append(GuideLine& line, Interval stretch, double leftM) const;

    GuideLine line_;
    std::vector<Placed> placed_;
    BoxTree tree_;
};

}  // namespace furrow
