#pragma once

#include "planner/geometry/box_tree.h"
#include "planner/geometry/curve.h"
#include "planner/geometry/polygon.h"

#include <vector>

namespace furrow {

/// The edges of a mainland, sorted for lines that are cut to it. Immutable; thread-safe.
class MainlandEdges {
public:
    explicit MainlandEdges(const MultiPolygon& mainland);

    /// Even-odd rule, holes included. Cost: O(log n) and the edges level with the point.
    bool contains(Point point) const;

    /// The parts of a line inside, in order, with ends exact to a millimetre.
    std::vector<Curve> partsInside(const Curve& line) const;

    Bounds box() const { return box_; }
    /// Points of the edges, no farther apart than `apart`.
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
