#pragma once

#include "planner/geometry/polygon.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace furrow {

/// How far points are from the edges of polygons, for points near them. Edges are sorted into square cells.
/// Immutable; may be asked by several threads at once.
class BoundaryDistance {
public:
    /// @param reach  distances above it are not told; > 0
    BoundaryDistance(const MultiPolygon& polygons, Length reach);

    /// Metres inside the nearest edge, negative outside, where no edge is within reach by the reach; nothing inside
    /// where none is. Cost: the edges in the cells around the point.
    std::optional<double> insideM(Point point) const;
    double reachM() const { return reachM_; }
    /// How deep edges lie in a shape, each at the middle of what of it is in there; 0 where none is. Asked around a place that is no farther than the reach from all of the shape. Cost: the edges in its
    /// cell times the shape's sides.
    double crossedM(Point around, const Ring& shape) const;

    /// Whether an edge gets deeper into a rectangle than by `touchingM`.
    /// @param origin, along  the frame: where it is and its x axis, a unit vector
    /// @param rectangle      in that frame, less than twice the reach from side to side
    /// Cost: the edges near the rectangle.
    bool reachInto(Point origin, Point along, const Bounds& rectangle, double touchingM) const;

    /// Corners that point inwards, where a shape can be poked between its own corners; those with x from low to
    /// high.
    std::span<const Point> inwardCorners(double low, double high) const;

private:
    struct Edge {
        Point from;
        Point way;         ///< to its other end
        double perSquare;  ///< 1 / its length squared, 0 without one
        Point fromNormal;  ///< sums of the inward normals at the edge's ends: which side a corner is on
        Point toNormal;
    };
    void findMeetings();
    void sortIntoCells();
    void findSides();
    template <class Visit>
    void forEachCellNear(double reachM, const Visit& visit) const;
    /// Of a point that is farther than the reach from all edges.
    bool isInside(Point point) const;
    /// Positive inside: of a point that is nearest to a corner at which several rings meet.
    double sideAtMeeting(Point point, Point corner) const;
    /// Its column and its row; the first ones where a point lies before them.
    std::pair<std::size_t, std::size_t> cellAt(Point point) const;
    /// Nothing of a point beyond all cells.
    std::optional<std::size_t> cellOf(Point point) const;
    /// Edges near a point; none far from all.
    std::span<const std::uint32_t> edgesNear(Point point) const;

    double reachM_;
    std::vector<Edge> edges_;
    std::vector<Point> inwardCorners_;  // by x
    std::vector<Point> meetings_;       // corners at which several rings meet
    // Square cells in rows, from the lower left corner on: those of cell i are edgesOf_[firstOf_[i]] and on.
    double cellM_;
    double perCell_ = 0.0;  ///< 1 / cellM_
    Point corner_;
    std::size_t columns_ = 0;
    std::size_t rows_ = 0;
    std::vector<std::uint32_t> firstOf_;
    std::vector<std::uint32_t> edgesOf_;
    enum class Side : std::uint8_t { Outside, Inside, Both };
    std::vector<Side> sides_;  ///< of the edges, on which each cell lies
};

/// How far a point is from the sides of a ring, negative inside.
double awayFrom(const Ring& shape, Point point);

}  // namespace furrow
