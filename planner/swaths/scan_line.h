#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/swaths/objective.h"
#include "planner/swaths/swath.h"
#include "planner/units/quantity.h"

#include <optional>
#include <utility>
#include <vector>

namespace furrow {

/// What becomes of the width that is left over when swaths are laid side by side.
enum class LastPass {
    Overlap,  ///< spacing kept, the last swath is moved back to the edge and overlaps its neighbour
    Spread,   ///< spacing reduced evenly so that all fit
    /// Spacing kept, the shift is free. A rest of half a width or more gets a swath that reaches beyond the edges, as in
    /// the paper; what is less stays uncovered.
    Gap,
};

struct SwathSpacing {
    Length width;    ///< > 0
    Length overlap;  ///< in [0, width)
    LastPass lastPass = LastPass::Overlap;
    /// A point that one of the tracks runs through (an AB line); without it they start at the edge.
    std::optional<Point> anchor;
    /// Whether there is room beyond the mainland's edge for what LastPass::Gap lays across it. Without, that swath is
    /// moved back to the edge.
    bool overEdge = true;

    /// Whether a rest of the width gets a swath where LastPass::Gap leaves the others out.
    bool isWorthASwath(Length rest) const;
};

/// What the time of a heading is estimated with: to and fro, with the machine's own curves in between.
struct DrivingModel {
    Speed working;
    Speed turning;
    Length radius;
    Length lead;  ///< how far the vehicle's reference point is ahead of the implement
};

/// The swaths of one mainland in any heading, by walking its edges with a scan line: vertices are rotated
/// once, each swath is the stretch between two crossings of its centre line (even-odd, holes included),
/// and covered area is the exact integral of the section length, clamped to the swath's ends. No polygon
/// boolean anywhere. Immutable; may be asked by several threads at once.
class ScanLine {
public:
    /// @param mainland  valid polygons in metres; not kept
    /// @param driving   for the time; without it times are 0
    ScanLine(const MultiPolygon& mainland, const SwathSpacing& spacing,
             const std::optional<DrivingModel>& driving = {});

    /// Whether any heading needs more swaths than can be told apart on screen or on the land: a width of
    /// centimetres on a field of kilometres.
    bool tooManyTracks() const;

    /// Exact figures of one heading, with the layout that is best for the objective: with LastPass::Overlap
    /// the side that carries the moved swath, with LastPass::Gap the shift. Cost: O(n log n + swaths) for n
    /// vertices and each of the layouts (2, 1 and 9), no allocation after the first call on a thread.
    HeadingFigures figures(Angle heading, SwathObjective objective = SwathObjective::Coverage) const;

    /// Number and length of swaths alone, of the layout that is best in those; areas are 0. Several times cheaper.
    HeadingFigures lineFigures(Angle heading, SwathObjective objective) const;

    /// No layout of this heading takes less time than this; several times cheaper than the time itself. 0
    /// without a driving model.
    /// @param enough  a bound above it may be less than it could be, and cheaper
    Duration timeBound(Angle heading, Duration enough) const;

    /// The swaths behind these figures, ordered by track, then along the heading.
    SwathSet swaths(Angle heading, SwathObjective objective = SwathObjective::Coverage) const;

    /// How many tracks a mainland of this height across the heading needs: a lower bound of the number of
    /// swaths of a mainland in one piece.
    int trackCount(Length height) const;

    /// Of the mainland across a heading. Cost: O(n).
    Length heightAcross(Angle heading) const;

private:
    struct Walk;

    void rotate(Angle heading, Walk& walk) const;
    /// The layouts there are to choose from are numbered from 0.
    int layoutCount(const Walk& walk) const;
    bool movesBack(const Walk& walk) const;
    void lay(int layout, Walk& walk) const;
    void layThroughAnchor(Walk& walk) const;
    void findCrossings(Walk& walk) const;
    void findSlabs(Walk& walk) const;
    HeadingFigures measureLines(const Walk& walk) const;
    /// By one swath or more, and by two or more, square metres.
    std::pair<double, double> coveredAreas(const Walk& walk) const;
    HeadingFigures measure(SwathObjective objective, Walk& walk) const;
    /// Of the layout with the best lines; `walk` is rotated.
    HeadingFigures linesOf(SwathObjective objective, Walk& walk) const;
    /// To and fro with turns of the length that `turnLength(from, to)` gives in metres.
    template <class TurnLength>
    Duration drivingTime(const Walk& walk, const TurnLength& turnLength) const;
    Duration missedTime(const HeadingFigures& figures) const;
    /// The best layout's number and figures; `walk` is rotated and holds any of them.
    std::pair<int, HeadingFigures> best(Angle heading, SwathObjective objective, Walk& walk) const;

    // Rings one after the other; ringEnds_[i] is one past the last vertex of ring i.
    std::vector<Point> vertices_;
    std::vector<std::size_t> ringEnds_;
    Point origin_;
    double areaM2_ = 0.0;
    double diameterM_ = 0.0;
    SwathSpacing spacing_;
    std::optional<DrivingModel> driving_;
    Length shortestTurn_;  // between two neighbouring tracks, wherever their ends are
};

}  // namespace furrow
