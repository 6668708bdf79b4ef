#pragma once

#include "planner/path/path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace furrow {

// Internal to the comparison: the path in straight pieces, and the pieces near a place.

/// Two consecutive samples of the path.
struct PathEdge {
    Point from;
    Point along;  ///< unit vector
    double lengthM = 0.0;
    double sM = 0.0;  ///< at `from`
    double sPerM = 1.0;
    std::uint32_t segment = 0;
    bool first = false;
    bool last = false;
};

std::vector<PathEdge> edgesOf(const Path& path);

/// The nearest point of an edge.
struct Foot {
    double alongM = 0.0;                                    ///< from the edge's beginning, within its length
    double offM = std::numeric_limits<double>::infinity();  ///< distance
};

Foot footOn(const PathEdge& edge, Point place);

/// Square cells with the edges that run through them.
class PathEdgeGrid {
public:
    // Edges are entered in steps of half a cell, so that each of their points is within a quarter of a cell
    // of an entered one. With cells of 4/3 of the radius, no point within the radius is then farther from an
    // entered one than a cell is wide.
    static constexpr double kCellOfRadius = 4.0 / 3.0;

    PathEdgeGrid(std::span<const PathEdge> edges, double radiusM);

    /// Calls `visit(edge index)` for every edge within the radius of a place, and for others, some twice.
    template <class Visit>
    void near(Point place, Visit&& visit) const {
        const double column = std::floor((place.x - low_.x) / cellM_);
        const double row = std::floor((place.y - low_.y) / cellM_);
        // Also false for places that are not finite.
        if (!(column >= -1.0 && row >= -1.0 && column <= static_cast<double>(columns_) &&
              row <= static_cast<double>(rows_))) {
            return;
        }
        for (double r = row - 1.0; r <= row + 1.0; ++r) {
            for (double c = column - 1.0; c <= column + 1.0; ++c) {
                if (r >= 0.0 && c >= 0.0 && r < static_cast<double>(rows_) &&
                    c < static_cast<double>(columns_)) {
                    const std::size_t cell =
                        static_cast<std::size_t>(r) * columns_ + static_cast<std::size_t>(c);
                    for (std::size_t i = begin_[cell]; i < begin_[cell + 1]; ++i) {
                        visit(entries_[i]);
                    }
                }
            }
        }
    }

private:
    std::size_t cellOf(Point place) const {
        const auto column = static_cast<std::size_t>(std::max(0.0, (place.x - low_.x) / cellM_));
        const auto row = static_cast<std::size_t>(std::max(0.0, (place.y - low_.y) / cellM_));
        return std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1);
    }

    /// Calls `visit(cell)` along an edge.
    template <class Visit>
    void walk(const PathEdge& edge, Visit&& visit) const {
        const auto steps = static_cast<std::size_t>(std::ceil(2.0 * edge.lengthM / cellM_)) + 1;
        std::size_t before = SIZE_MAX;
        for (std::size_t i = 0; i <= steps; ++i) {
            const double at = edge.lengthM * static_cast<double>(i) / static_cast<double>(steps);
            const std::size_t cell = cellOf(edge.from + at * edge.along);
            if (cell != before) {
                visit(cell);
            }
            before = cell;
        }
    }

    void fill(std::span<const PathEdge> edges);

    Point low_;
    double cellM_ = 1.0;
    std::size_t columns_ = 1;
    std::size_t rows_ = 1;
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> entries_;
};

}  // namespace furrow
