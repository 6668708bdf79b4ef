#include "planner/audit/boundary_index.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace furrow {

namespace {

/// Turns counts, one behind their slot, into where each slot begins.
void accumulate(std::vector<std::uint32_t>& counts) {
    std::partial_sum(counts.begin(), counts.end(), counts.begin());
}

}  // namespace

double distanceToSegment(Point point, const Edge& edge) {
    const Point along = edge.to - edge.from;
    const double square = dot(along, along);
    const double t = square > 0.0 ? std::clamp(dot(point - edge.from, along) / square, 0.0, 1.0) : 0.0;
    return norm(point - (edge.from + t * along));
}

BoundaryIndex::BoundaryIndex(const MultiPolygon& polygons) : bounds_{bounds(polygons)} {
    forEachEdge(polygons, [&](Point from, Point to) { edges_.push_back({from, to}); });
    const double wanted = std::clamp(static_cast<double>(edges_.size()), 256.0, 65536.0);
    const double width = std::max(bounds_.width(), 1e-3);
    const double height = std::max(bounds_.height(), 1e-3);
    cellM_ = std::max({std::sqrt(width * height / wanted), width / 4096.0, height / 4096.0});
    columns_ = static_cast<std::size_t>(width / cellM_) + 1;
    rows_ = static_cast<std::size_t>(height / cellM_) + 1;
    cellStart_.assign(columns_ * rows_ + 1, 0);
    rowStart_.assign(rows_ + 1, 0);
    const auto forEachCell = [&](const Edge& edge, const auto& take) {
        const std::size_t c0 = column(std::min(edge.from.x, edge.to.x));
        const std::size_t c1 = column(std::max(edge.from.x, edge.to.x));
        const std::size_t r0 = row(std::min(edge.from.y, edge.to.y));
        const std::size_t r1 = row(std::max(edge.from.y, edge.to.y));
        for (std::size_t r = r0; r <= r1; ++r) {
            for (std::size_t c = c0; c <= c1; ++c) {
                take(r * columns_ + c);
            }
        }
    };
    const auto forEachRow = [&](const Edge& edge, const auto& take) {
        const std::size_t r1 = row(std::max(edge.from.y, edge.to.y));
        for (std::size_t r = row(std::min(edge.from.y, edge.to.y)); r <= r1; ++r) {
            take(r);
        }
    };
    for (const Edge& edge : edges_) {
        forEachCell(edge, [&](std::size_t cell) { ++cellStart_[cell + 1]; });
        forEachRow(edge, [&](std::size_t r) { ++rowStart_[r + 1]; });
    }
    accumulate(cellStart_);
    accumulate(rowStart_);
    cellEdges_.resize(cellStart_.back());
    rowEdges_.resize(rowStart_.back());
    std::vector<std::uint32_t> nextCell{cellStart_.begin(), cellStart_.end() - 1};
    std::vector<std::uint32_t> nextRow{rowStart_.begin(), rowStart_.end() - 1};
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        forEachCell(edges_[i], [&](std::size_t cell) { cellEdges_[nextCell[cell]++] = i; });
        forEachRow(edges_[i], [&](std::size_t r) { rowEdges_[nextRow[r]++] = i; });
    }
}

bool BoundaryIndex::contains(Point point) const {
    if (edges_.empty() || point.y < bounds_.min.y || point.y > bounds_.max.y || point.x < bounds_.min.x ||
        point.x > bounds_.max.x) {
        return false;
    }
    const std::size_t r = row(point.y);
    bool inside = false;
    for (std::uint32_t i = rowStart_[r]; i < rowStart_[r + 1]; ++i) {
        const auto& [a, b] = edges_[rowEdges_[i]];
        if ((a.y > point.y) != (b.y > point.y) &&
            point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            inside = !inside;
        }
    }
    return inside;
}

double BoundaryIndex::distanceWithin(Point point, double limit) const {
    double nearest = limit;
    visitNear({.min = point - Point{limit, limit}, .max = point + Point{limit, limit}},
              [&](const Edge& edge) { nearest = std::min(nearest, distanceToSegment(point, edge)); });
    return nearest;
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
