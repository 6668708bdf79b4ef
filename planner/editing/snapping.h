#pragma once

#include "planner/editing/field_shape.h"
#include "planner/units/quantity.h"

#include <optional>
#include <span>
#include <vector>

namespace furrow {

enum class SnapKind { Vertex, Edge, RightAngle, Straight };

/// Where a place is drawn to, and why.
struct Snap {
    Point place;
    std::vector<SnapKind> kinds;  ///< none where it stays where it is; two where two lines cross
    /// Lines to show: from the vertex that the angle is at to the place.
    std::vector<Point> from;

    bool isSnapped() const { return !kinds.empty(); }
};

/// A line that a place may be drawn onto.
struct SnapLine {
    Point through;
    Point along;  ///< of length 1
    SnapKind kind = SnapKind::RightAngle;
};

/// The lines on which the edge to a new or moved vertex makes a right angle with the edge before it, or goes
/// straight on: `anchor` is the vertex beside it, `before` the one beyond that.
std::vector<SnapLine> angleLines(Point anchor, Point before);

/// Draws a place to what is within reach: the nearest vertex; else where two of the lines, or a line and an edge,
/// cross; else the nearest line or edge.
///
/// @param except  a vertex that is being moved: it and the edges at it draw nothing
/// Cost: O(n) for n vertices and few lines.
Snap snapped(const FieldShape& shape, Point place, Length reach, std::span<const SnapLine> lines,
             std::optional<std::pair<OutlineId, std::size_t>> except = std::nullopt);

}  // namespace furrow
