#pragma once

#include "planner/geometry/point.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

/// Points in the squares of a grid, for questions about those near a place. Points in metres, finite, of any
/// number; they may coincide. Points can be taken out. Questions from several threads at once while none is
/// taken.
class PointGrid {
public:
    PointGrid() = default;
    /// Cost: O(n), with about half as many squares as points.
    explicit PointGrid(std::vector<Point> points);

    /// Whether a point lies nearer to the place than this. Cost: the squares that far around it.
    bool anyNearer(Point place, double thanM) const;
    /// The index of the nearest point, of equally near ones the first. None: all were taken out. Cost: the
    /// squares as far around as that point.
    std::optional<std::size_t> nearest(Point place) const;
    /// No answer from now on; it may have been taken out before.
    void takeOut(std::size_t index);

private:
    struct Square {
        long column = 0;
        long row = 0;
    };
    Square squareOf(Point place) const;
    const std::vector<std::size_t>& in(Square square) const;

    std::vector<Point> points_;
    Point corner_;
    double squareM_ = 1.0;
    long columns_ = 0;
    long rows_ = 0;
    std::vector<std::vector<std::size_t>> squares_;
    std::size_t left_ = 0;
};

}  // namespace furrow
