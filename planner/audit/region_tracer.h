#pragma once

#include "planner/geometry/polygon.h"

#include <cstdint>
#include <vector>

namespace furrow {

/// Joins trapezoids to polygons: they come row by row, from low to high y, each row from left to right.
///
/// Where two rows meet, the ends of their trapezoids become nodes, and what only one of them covers between
/// two nodes becomes an edge. Every node then has as many edges in as out, so that rings always close,
/// whatever rounding did to the coordinates.
class RegionTracer {
public:
    /// Of a side that is not known to be part of any line. Between two that are, what goes on from row to row is one
    /// trapezoid.
    static constexpr std::uint32_t kNoLine = ~0U;

    /// One trapezoid; x at its lower and upper side.
    struct Span {
        double leftLow = 0.0;
        double leftHigh = 0.0;
        double rightLow = 0.0;
        double rightHigh = 0.0;
        std::uint32_t leftLine = kNoLine;
        std::uint32_t rightLine = kNoLine;
    };

    /// The next row, between two heights; not below what came before.
    void addRow(double low, double high, const std::vector<Span>& spans);

    /// Polygons of all rows, largest first; those under `leastAreaM2` are left out. Ends the tracing.
    MultiPolygon finish(double leastAreaM2);

private:
    struct Edge {
        std::uint32_t from;
        std::uint32_t to;
        std::uint32_t piece;  ///< any span of the connected piece
    };
    /// A span of the row before, whose upper side waits for the next row.
    struct Open {
        Span span;
        std::uint32_t leftNode;
        std::uint32_t rightNode;
        std::uint32_t piece;
        std::uint32_t same;  ///< where it goes on in the row at hand, or comes from in the row before
    };
    struct End {
        double x;
        Open* open;
        bool isAbove;
        bool isLeft;
    };

    std::vector<Open> rowOf(const std::vector<Span>& spans);
    void endAll();
    void join(double height, std::vector<Open>& above);
    std::uint32_t newNode(Point place);
    std::uint32_t pieceOf(std::uint32_t piece);
    void unite(std::uint32_t a, std::uint32_t b);
    void addEdge(std::uint32_t from, std::uint32_t to, std::uint32_t piece);
    std::vector<std::pair<std::uint32_t, Ring>> closeRings();

    double height_ = 0.0;
    std::vector<Open> below_;
    std::vector<End> ends_;  ///< at the height where rows are joined
    std::vector<Point> nodes_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> parents_;  ///< union-find over spans
};

}  // namespace furrow
