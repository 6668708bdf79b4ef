#pragma once

#include "planner/geometry/polygon.h"

#include <cstdint>
#include <vector>

namespace furrow {

/// Joins trapezoids to polygons. They come row by row, from low to high y, each row from left to right.
///
/// At the join of two rows, the ends of their trapezoids become nodes. A piece between two nodes that only
/// one of the rows covers becomes an edge. Every node then has as many edges in as out. So rings always
/// close, whatever the rounding of the coordinates.
class RegionTracer {
public:
    /// For a side that is not known to be part of any line. Between two known lines, spans that continue from
    /// row to row are one trapezoid.
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

    /// The next row, between two heights, not below the rows before.
    void addRow(double low, double high, const std::vector<Span>& spans);

    /// Polygons of all rows, largest first, without those under `leastAreaM2`. Ends the tracing.
    MultiPolygon finish(double leastAreaM2);

private:
    struct Edge {
        std::uint32_t from;
        std::uint32_t to;
        std::uint32_t piece;  ///< any span of the connected piece
    };
    /// A span of the row before. Its upper side waits for the next row.
    struct Open {
        Span span;
        std::uint32_t leftNode;
        std::uint32_t rightNode;
        std::uint32_t piece;
        std::uint32_t same;  ///< its continuation in the current row, or its origin in the row before
    };
    struct End {
        double x;
        Open* open;
        bool isAbove;
        bool isLeft;
    };

    bool goesOn(const std::vector<Span>& spans);
    void readRow(const std::vector<Span>& spans);
    void endAll();
    void join(double height);
    std::uint32_t newNode(Point place);
    std::uint32_t pieceOf(std::uint32_t piece);
    void unite(std::uint32_t a, std::uint32_t b);
    void addEdge(std::uint32_t from, std::uint32_t to, std::uint32_t piece);
    std::vector<std::pair<std::uint32_t, Ring>> closeRings();
    std::pair<std::uint32_t, Ring> takeLoop(std::vector<std::uint32_t>& way, std::size_t begin,
                                            std::vector<std::uint32_t>& placeOnWay);

    double height_ = 0.0;
    std::vector<Open> below_;
    std::vector<Open> above_;  ///< the row that is added now
    std::vector<End> ends_;    ///< at the height at which rows are joined
    std::vector<Point> nodes_;
    std::vector<Edge> edges_;
    std::vector<std::uint32_t> parents_;  ///< union-find over spans
};

}  // namespace furrow
