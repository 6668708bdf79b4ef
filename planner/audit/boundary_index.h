#pragma once

#include "planner/audit/slotted_items.h"
#include "planner/geometry/polygon.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace furrow {

struct Edge {
    Point from;
    Point to;
};

/// The edges of an area in a grid, for questions about nearby places. Immutable; thread-safe.
class BoundaryIndex {
public:
    explicit BoundaryIndex(const MultiPolygon& polygons);

    /// Inside by the even-odd rule; on the edge either answer. O(1) away from edges, O(edges in the row) near
    /// them.
    bool contains(Point point) const;

    /// Calls `visit(edge)` for every edge near the box, for some edges more than once.
    template <class Visit>
    void visitNear(const Bounds& box, Visit&& visit) const {
        if (edges_.empty() || box.max.x < bounds_.min.x || box.min.x > bounds_.max.x ||
            box.max.y < bounds_.min.y || box.min.y > bounds_.max.y) {
            return;
        }
        const std::size_t firstColumn = column(box.min.x);
        const std::size_t lastColumn = column(box.max.x);
        const std::size_t lastRow = row(box.max.y);
        for (std::size_t r = row(box.min.y); r <= lastRow; ++r) {
            for (std::size_t c = firstColumn; c <= lastColumn; ++c) {
                const std::size_t cell = r * columns_ + c;
                for (const std::uint32_t i : inCells_.in(cell)) {
                    visit(edges_[i]);
                }
            }
        }
    }

    /// Whether a disc is inside and touches no edge.
    bool containsDisc(Point middle, double radius) const;
    /// The distance to the nearest edge, at any range. Infinite without edges.
    double distance(Point point) const;

private:
    enum class Cell : std::uint8_t { Edges, Inside, Outside };

    void fillCells();
    void fillRows();
    void findInside();
    bool containsByRow(Point point) const;
    double distanceWithin(Point point, double limit) const;

    /// Calls `take(cell)` for every cell that the edge runs through.
    template <class Take>
    void forEachCell(const Edge& edge, Take&& take) const;

    std::size_t column(double x) const { return at(x - bounds_.min.x, columns_); }
    std::size_t row(double y) const { return at(y - bounds_.min.y, rows_); }
    std::size_t at(double offset, std::size_t count) const {
        return static_cast<std::size_t>(std::clamp(offset / cellM_, 0.0, static_cast<double>(count) - 1.0));
    }

    std::vector<Edge> edges_;
    Bounds bounds_;
    double cellM_ = 1.0;
    std::size_t columns_ = 1;
    std::size_t rows_ = 1;
    SlottedItems inCells_;  ///< edges
    SlottedItems inRows_;
    std::vector<Cell> cells_;
};

double squaredDistanceToSegment(Point point, const Edge& edge);

}  // namespace furrow
