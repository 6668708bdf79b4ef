#include "planner/geometry/point_grid.h"

#include "planner/geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace furrow {

namespace {

// Fewer squares take longer to look through, more of them are mostly empty.
constexpr double kPointsPerSquare = 2.0;
constexpr double kLeastSquareM = 1e-3;

}  // namespace

PointGrid::PointGrid(std::vector<Point> points) : points_{std::move(points)}, left_{points_.size()} {
    if (points_.empty()) {
        return;
    }
    const Bounds box = bounds(points_);
    const double squares = std::max(1.0, static_cast<double>(points_.size()) / kPointsPerSquare);
    corner_ = box.min;
    // Points on a line have no area; along it there are no more squares than points.
    squareM_ = std::max({std::sqrt(box.width() * box.height() / squares),
                         std::max(box.width(), box.height()) / squares, kLeastSquareM});
    columns_ = static_cast<long>(box.width() / squareM_) + 1;
    rows_ = static_cast<long>(box.height() / squareM_) + 1;
    squares_.resize(static_cast<std::size_t>(columns_ * rows_));
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const Square square = squareOf(points_[i]);
        squares_[static_cast<std::size_t>(square.row * columns_ + square.column)].push_back(i);
    }
}

PointGrid::Square PointGrid::squareOf(Point place) const {
    const auto along = [this](double fromM, long count) {
        return static_cast<long>(std::clamp(fromM / squareM_, 0.0, static_cast<double>(count - 1)));
    };
    return {along(place.x - corner_.x, columns_), along(place.y - corner_.y, rows_)};
}

const std::vector<std::size_t>& PointGrid::in(Square square) const {
    return squares_[static_cast<std::size_t>(square.row * columns_ + square.column)];
}

bool PointGrid::anyNearer(Point place, double thanM) const {
    if (left_ == 0) {
        return false;
    }
    const Square low = squareOf(place - Point{thanM, thanM});
    const Square high = squareOf(place + Point{thanM, thanM});
    for (long row = low.row; row <= high.row; ++row) {
        for (long column = low.column; column <= high.column; ++column) {
            if (std::ranges::any_of(in({column, row}),
                                    [&](std::size_t i) { return distance(points_[i], place) < thanM; })) {
                return true;
            }
        }
    }
    return false;
}

std::optional<std::size_t> PointGrid::nearest(Point place) const {
    if (left_ == 0) {
        return std::nullopt;
    }
    // A place beside the grid counts as in its nearest square; no point is nearer to it than to that.
    const Square middle = squareOf(place);
    double leastM = std::numeric_limits<double>::infinity();
    std::size_t best = points_.size();
    const auto look = [&](Square square) {
        if (square.column < 0 || square.column >= columns_ || square.row < 0 || square.row >= rows_) {
            return;
        }
        for (const std::size_t i : in(square)) {
            const double awayM = distance(points_[i], place);
            if (awayM < leastM || (awayM == leastM && i < best)) {
                leastM = awayM;
                best = i;
            }
        }
    };
    const long most = std::max(columns_, rows_);
    for (long ring = 0; ring < most && static_cast<double>(ring - 1) * squareM_ <= leastM; ++ring) {
        for (long side = -ring; side <= ring; ++side) {
            look({middle.column + side, middle.row - ring});
            look({middle.column + side, middle.row + ring});
            look({middle.column - ring, middle.row + side});
            look({middle.column + ring, middle.row + side});
        }
    }
    return best;
}

void PointGrid::takeOut(std::size_t index) {
    const Square square = squareOf(points_[index]);
    left_ -= std::erase(squares_[static_cast<std::size_t>(square.row * columns_ + square.column)], index);
}

}  // namespace furrow
