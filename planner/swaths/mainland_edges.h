#pragma once

#include "planner/geometry/box_tree.h"
#include "planner/geometry/polygon.h"
#include "planner/turns/turn.h"

#include <vector>

namespace furrow {

/// The edges of a mainland, sorted for lines that are cut to it. Immutable; may be asked by several threads at once.
class MainlandEdges {
public:
    explicit MainlandEdges(const MultiPolygon& mainland);

    /// Even-odd, holes included. Cost: O(log n) and the edges level with the point.
    bool contains(Point point) const;

    /// The parts of a line that lie inside, in their order, with ends to a millimetre.
    std::vector<Turn> partsInside(const Turn& line) const;

    Bounds box() const { return box_; }
    /// Points of the edges, no farther apart than this.
    std::vector<Point> pointsAlong(Length apart) const;

private:
    struct Edge {
        Point from;
        Point to;
    };
    std::vector<Edge> edges_;
    BoxTree tree_;
    Bounds box_;
};

}  // namespace furrow
