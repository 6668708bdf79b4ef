#include "planner/audit/boundary_index.h"

#include <cmath>
#include <limits>

namespace furrow {

namespace {

// A few edges get a fine grid, too. An empty cell then answers most questions.
constexpr double kFewestCells = 1024.0;
constexpr double kMostCells = 65536.0;
/// A point on the line between two cells belongs to both.
constexpr double kCellSlackM = 1e-6;

}  // namespace

double squaredDistanceToSegment(Point point, const Edge& edge) {
    const Point along = edge.to - edge.from;
    const double square = dot(along, along);
    const double t = square > 0.0 ? std::clamp(dot(point - edge.from, along) / square, 0.0, 1.0) : 0.0;
    const Point away = point - (edge.from + t * along);
    return dot(away, away);
}

BoundaryIndex::BoundaryIndex(const MultiPolygon& polygons) : bounds_{bounds(polygons)} {
    forEachEdge(polygons, [&](Point from, Point to) { edges_.push_back({from, to}); });
    const double wanted = std::clamp(4.0 * static_cast<double>(edges_.size()), kFewestCells, kMostCells);
    const double width = std::max(bounds_.width(), 1e-3);
    const double height = std::max(bounds_.height(), 1e-3);
    cellM_ = std::max({std::sqrt(width * height / wanted), width / 4096.0, height / 4096.0});
    columns_ = static_cast<std::size_t>(width / cellM_) + 1;
    rows_ = static_cast<std::size_t>(height / cellM_) + 1;
    fillCells();
    fillRows();
    findInside();
}

template <class Take>
void BoundaryIndex::forEachCell(const Edge& edge, Take&& take) const {
    const auto& [low, high] =
        edge.from.y < edge.to.y ? std::pair{edge.from, edge.to} : std::pair{edge.to, edge.from};
    const double slope = high.y > low.y ? (high.x - low.x) / (high.y - low.y) : 0.0;
    const std::size_t lastRow = row(high.y + kCellSlackM);
    for (std::size_t r = row(low.y - kCellSlackM); r <= lastRow; ++r) {
        // The part of the edge between the lower and the upper side of the row.
        const double from = bounds_.min.y + static_cast<double>(r) * cellM_ - kCellSlackM;
        const double to = from + cellM_ + 2.0 * kCellSlackM;
        const double a = low.y >= from ? low.x : low.x + slope * (from - low.y);
        const double b = high.y <= to ? high.x : low.x + slope * (to - low.y);
        const std::size_t lastColumn = column(std::max(a, b) + kCellSlackM);
        for (std::size_t c = column(std::min(a, b) - kCellSlackM); c <= lastColumn; ++c) {
            take(r * columns_ + c);
        }
    }
}

void BoundaryIndex::fillCells() {
    inCells_ = SlottedItems{columns_ * rows_, [&](const auto& take) {
                                for (std::uint32_t i = 0; i < edges_.size(); ++i) {
                                    forEachCell(edges_[i], [&](std::size_t cell) { take(cell, i); });
                                }
                            }};
}

void BoundaryIndex::fillRows() {
    inRows_ =
        SlottedItems{rows_, [&](const auto& take) {
                         for (std::uint32_t i = 0; i < edges_.size(); ++i) {
                             const Edge& edge = edges_[i];
                             const std::size_t last = row(std::max(edge.from.y, edge.to.y));
                             for (std::size_t r = row(std::min(edge.from.y, edge.to.y)); r <= last; ++r) {
                                 take(r, i);
                             }
                         }
                     }};
}

/// A cell without edges is inside or outside as a whole, and so are empty cells beside it.
void BoundaryIndex::findInside() {
    cells_.assign(columns_ * rows_, Cell::Edges);
    for (std::size_t r = 0; r < rows_; ++r) {
        for (std::size_t c = 0; c < columns_; ++c) {
            const std::size_t cell = r * columns_ + c;
            if (!inCells_.in(cell).empty()) {
                continue;
            }
            if (c > 0 && cells_[cell - 1] != Cell::Edges) {
                cells_[cell] = cells_[cell - 1];
                continue;
            }
            const Point middle =
                bounds_.min + cellM_ * Point{static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5};
            cells_[cell] = containsByRow(middle) ? Cell::Inside : Cell::Outside;
        }
    }
}

bool BoundaryIndex::contains(Point point) const {
    if (edges_.empty() || point.y < bounds_.min.y || point.y > bounds_.max.y || point.x < bounds_.min.x ||
        point.x > bounds_.max.x) {
        return false;
    }
    const Cell cell = cells_[row(point.y) * columns_ + column(point.x)];
    return cell == Cell::Edges ? containsByRow(point) : cell == Cell::Inside;
}

bool BoundaryIndex::containsByRow(Point point) const {
    const std::size_t r = row(point.y);
    bool inside = false;
    for (const std::uint32_t i : inRows_.in(r)) {
        const auto& [a, b] = edges_[i];
        if ((a.y > point.y) != (b.y > point.y) &&
            point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            inside = !inside;
        }
    }
    return inside;
}

bool BoundaryIndex::containsDisc(Point middle, double radius) const {
    if (!contains(middle)) {
        return false;
    }
    const double square = radius * radius;
    const std::size_t lastRow = row(middle.y + radius);
    const std::size_t lastColumn = column(middle.x + radius);
    for (std::size_t r = row(middle.y - radius); r <= lastRow; ++r) {
        for (std::size_t c = column(middle.x - radius); c <= lastColumn; ++c) {
            const std::size_t cell = r * columns_ + c;
            for (const std::uint32_t i : inCells_.in(cell)) {
                if (squaredDistanceToSegment(middle, edges_[i]) < square) {
                    return false;
                }
            }
        }
    }
    return true;
}

double BoundaryIndex::distanceWithin(Point point, double limit) const {
    double nearest = limit * limit;
    visitNear({.min = point - Point{limit, limit}, .max = point + Point{limit, limit}},
              [&](const Edge& edge) { nearest = std::min(nearest, squaredDistanceToSegment(point, edge)); });
    return std::sqrt(nearest);
}

double BoundaryIndex::distance(Point point) const {
    if (edges_.empty()) {
        return std::numeric_limits<double>::infinity();
    }
    for (double limit = cellM_;; limit *= 2.0) {
        if (const double found = distanceWithin(point, limit); found < limit) {
            return found;
        }
    }
}

}  // namespace furrow
