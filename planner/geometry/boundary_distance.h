#pragma once

#include "planner/geometry/polygon.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace furrow {

/// The distance of points from the edges of polygons, for points near them. Edges are sorted into square
/// cells. Immutable; thread-safe.
class BoundaryDistance {
public:
    /// @param reach  largest distance that is measured; > 0
    BoundaryDistance(const MultiPolygon& polygons, Length reach);

    /// Metres inside the nearest edge, negative outside. If no edge is within reach: minus the reach outside,
    /// empty inside. Cost: the edges in the cells around the point.
    std::optional<double> insideM(Point point) const;
    double reachM() const { return reachM_; }
    /// The depth of edges in a shape, each measured at the middle of its part inside. 0 if no edge is inside.
    /// `around` is no farther than the reach from any place of the shape. Cost: the edges in its cell times
    /// the shape's sides.
    double crossedM(Point around, const Ring& shape) const;

    /// Whether an edge enters a rectangle deeper than `touchingM`.
    /// @param origin, along  the frame: its origin and its x axis, a unit vector
    /// @param rectangle      in that frame, less than twice the reach from side to side
    /// Cost: the edges near the rectangle.
    bool reachInto(Point origin, Point along, const Bounds& rectangle, double touchingM) const;

    /// Corners that point inwards, with x from low to high. Such a corner can poke a shape between the
    /// shape's own corners.
    std::span<const Point> inwardCorners(double low, double high) const;

private:
    struct Edge {
        Point from;
        Point way;         ///< to its other end
        double perSquare;  ///< 1 / its length squared, 0 without one
        Point fromNormal;  ///< sums of the inward normals at the edge's ends; they tell the side at a corner
        Point toNormal;
    };
    void findMeetings();
    void sortIntoCells();
    void findSides();
    template <class Visit>
    void forEachCellNear(double reachM, const Visit& visit) const;
    /// For a point farther than the reach from all edges.
    bool isInside(Point point) const;
    /// Positive inside. For a point nearest to a corner at which several rings meet.
    double sideAtMeeting(Point point, Point corner) const;
    /// Column and row of a point; the first ones if it lies before them.
    std::pair<std::size_t, std::size_t> cellAt(Point point) const;
    /// Empty for a point beyond all cells.
    std::optional<std::size_t> cellOf(Point point) const;
    /// Edges near a point. Empty if it is far from all.
    std::span<const std::uint32_t> edgesNear(Point point) const;

    double reachM_;
    std::vector<Edge> edges_;
    std::vector<Point> inwardCorners_;  // by x
    std::vector<Point> meetings_;       // corners at which several rings meet
    // Square cells in rows, from the lower left corner. The edges of cell i start at firstOf_[2 i] of
    // edgesOf_, with those that may be nearest; the others start at firstOf_[2 i + 1].
    double cellM_;
    double perCell_ = 0.0;  ///< 1 / cellM_
    Point corner_;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<std::uint32_t> firstOf_;
    std::vector<std::uint32_t> edgesOf_;
    enum class Side : std::uint8_t { Outside, Inside, Both };
    std::vector<Side> sides_;  ///< the side of the edges on which each cell lies
};

/// The distance of a point from the sides of a ring, negative inside.
double awayFrom(const Ring& shape, Point point);

}  // namespace furrow
