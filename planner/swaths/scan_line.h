#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/swaths/swath.h"
#include "planner/units/quantity.h"

#include <vector>

namespace furrow {

/// What becomes of the width that is left over when swaths are laid side by side.
enum class LastPass {
    Overlap,  ///< spacing kept, the last swath is moved back to the edge and overlaps its neighbour
    Spread,   ///< spacing reduced evenly so that all fit
};

struct SwathSpacing {
    Length width;    ///< > 0
    Length overlap;  ///< in [0, width)
    LastPass lastPass = LastPass::Overlap;
};

/// Every objective of one heading.
struct HeadingFigures {
    int count = 0;
    Length length;          ///< of all swaths
    double coverage = 0.0;  ///< A_cov, flat ends
    Area overlap;           ///< of the mainland, covered at least twice
};

/// The swaths of one mainland in any heading, by walking its edges with a scan line: vertices are rotated
/// once, each swath is the stretch between two crossings of its centre line (even-odd, holes included),
/// and covered area is the exact integral of the section length, clamped to the swath's ends. No polygon
/// boolean anywhere. Immutable; may be asked by several threads at once.
class ScanLine {
public:
    /// @param mainland  valid polygons in metres; not kept
    ScanLine(const MultiPolygon& mainland, const SwathSpacing& spacing);

    /// Whether any heading needs more swaths than can be told apart on screen or on the land: a width of
    /// centimetres on a field of kilometres.
    bool tooManyTracks() const;

    /// Exact figures of one heading. With LastPass::Overlap the side that covers more (then: overlaps
    /// less) carries the last swath. Cost: O(n log n + swaths) for n vertices, no allocation after the
    /// first call on a thread.
    HeadingFigures figures(Angle heading) const;

    /// The swaths behind these figures, ordered by track, then along the heading.
    SwathSet swaths(Angle heading) const;

private:
    struct Walk;
    /// On which side of the mainland the swath lies that was moved.
    enum class MovedSide { Last, First };

    void lay(MovedSide moved, Walk& walk) const;
    void rotate(Angle heading, Walk& walk) const;
    HeadingFigures measure(const Walk& walk) const;
    /// The better of both sides; `walk` then holds it.
    HeadingFigures best(Angle heading, Walk& walk) const;

    // Rings one after the other; ringEnds_[i] is one past the last vertex of ring i.
    std::vector<Point> vertices_;
    std::vector<std::size_t> ringEnds_;
    Point origin_;
    double areaM2_ = 0.0;
    double diameterM_ = 0.0;
    SwathSpacing spacing_;
};

}  // namespace furrow
