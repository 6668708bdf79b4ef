#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/swaths/edge_tree.h"
#include "planner/swaths/objective.h"
#include "planner/swaths/swath.h"
#include "planner/units/quantity.h"

#include <optional>
#include <utility>
#include <vector>

namespace furrow {

class Ladder;

/// The treatment of the remaining width when swaths are laid side by side.
enum class LastPass {
    Overlap,  ///< spacing kept; the last swath moves back to the edge and overlaps its neighbour
    Spread,   ///< spacing reduced evenly so that all fit
    /// Spacing kept, the shift is free. A rest of half a width or more gets a swath that reaches beyond the
    /// edges, as in the paper. A smaller rest stays uncovered.
    Gap,
};

struct SwathSpacing {
    Length width;    ///< > 0
    Length overlap;  ///< in [0, width)
    LastPass lastPass = LastPass::Overlap;
    /// A point on one of the tracks (an AB line). Without it the tracks start at the edge.
    std::optional<Point> anchor;
    /// Whether there is room beyond the mainland's edge for the last swath of LastPass::Gap. Without room,
    /// that swath is moved back to the edge.
    bool overEdge = true;

    /// Whether LastPass::Gap lays a swath on this rest of the width.
    bool isWorthASwath(Length rest) const;
};

/// The model for the time of a heading: to and fro, with the machine's own curves in between.
struct DrivingModel {
    Speed working;
    Speed turning;
    Length radius;    ///< of the shortest curve between two swaths; 0: straight, turning on the spot
    Length lead;      ///< distance of the vehicle's reference point ahead of the implement
    Duration change;  ///< for each change of swath beside its curve: stopping, turning on the spot
};

/// The swaths of one mainland in any heading. A scan line walks the edges: the vertices are rotated once, and
/// each swath is the stretch between two crossings of its centre line (even-odd, holes included). The covered
/// area is the exact integral of the section length, clamped to the swath's ends. No polygon booleans are
/// used. Immutable; thread-safe.
class ScanLine {
public:
    /// @param mainland  valid polygons in metres; not kept
    /// @param driving   for the time; without it times are 0
    ScanLine(const MultiPolygon& mainland, const SwathSpacing& spacing,
             const std::optional<DrivingModel>& driving = {});

    /// The largest distance across the mainland.
    Length diameter() const;

    /// Exact figures of one heading, with the best layout for the objective. LastPass::Overlap chooses the
    /// side of the moved swath, LastPass::Gap the shift. Cost: O(n log n + swaths) for n vertices and each of
    /// the layouts (2, 1 and 9). No allocation after the first call on a thread.
    HeadingFigures figures(Angle heading, SwathObjective objective = SwathObjective::Coverage) const;

    /// Number and length of swaths only, of the layout that is best in these. Areas are 0. Several times
    /// cheaper. For many vertices O(swaths log n).
    HeadingFigures lineFigures(Angle heading, SwathObjective objective) const;

    /// A lower bound of the time over all layouts of this heading. Several times cheaper than the time
    /// itself. 0 without a driving model.
    /// @param enough  a bound above this value need not be improved, which is cheaper
    Duration timeBound(Angle heading, Duration enough) const;

    /// The swaths behind these figures, ordered by track, then along the heading.
    SwathSet swaths(Angle heading, SwathObjective objective = SwathObjective::Coverage) const;

    /// The number of tracks for a mainland with this height across the heading. It is a lower bound of the
    /// number of swaths if the mainland is one piece.
    int trackCount(Length height) const;

    /// The height of the mainland across a heading. Cost: O(n).
    Length heightAcross(Angle heading) const;

private:
    struct Walk;

    void rotate(Angle heading, Walk& walk) const;
    /// The same for lines only. With many vertices only those beside tracks are rotated, later.
    void rotateForLines(Angle heading, Walk& walk) const;
    void turnTo(Angle heading, Walk& walk) const;
    template <class Visit>
    void forEachCrossedEdge(Walk& walk, const Visit& visit) const;
    template <class Visit>
    void forEachCrossedEdgeOf(const EdgeTree::Run& run, EdgeTree::Trend trend, const Walk& walk,
                              const Ladder& ladder, const Visit& visit) const;
    /// The possible layouts are numbered from 0.
    int layoutCount(const Walk& walk) const;
    bool movesBack(const Walk& walk) const;
    void lay(int layout, Walk& walk) const;
    void layThroughAnchor(Walk& walk) const;
    void findCrossings(Walk& walk) const;
    void findSlabs(Walk& walk) const;
    HeadingFigures measureLines(const Walk& walk) const;
    /// Area covered at least once, and at least twice, in square metres.
    std::pair<double, double> coveredAreas(const Walk& walk) const;
    HeadingFigures measure(SwathObjective objective, Walk& walk) const;
    /// Figures of the layout with the best lines. `walk` must be rotated.
    HeadingFigures linesOf(SwathObjective objective, Walk& walk) const;
    /// Time to and fro, with turns of the length `turnLength(from, to)` in metres.
    template <class TurnLength>
    Duration drivingTime(const Walk& walk, const TurnLength& turnLength) const;
    Duration missedTime(const HeadingFigures& figures) const;
    /// The number and figures of the best layout. Rotates `walk`, which afterwards holds any of the layouts.
    std::pair<int, HeadingFigures> best(Angle heading, SwathObjective objective, Walk& walk) const;

    // Rings one after the other; ringEnds_[i] is one past the last vertex of ring i.
    std::vector<Point> vertices_;
    std::vector<std::size_t> ringEnds_;
    EdgeTree tree_;  ///< of many edges; empty for few
    Point origin_;
    double areaM2_ = 0.0;
    double diameterM_ = 0.0;
    SwathSpacing spacing_;
    std::optional<DrivingModel> driving_;
    Length shortestTurn_;  // between two neighbouring tracks, wherever their ends are
};

}  // namespace furrow
