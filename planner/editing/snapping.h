#pragma once

#include "planner/editing/field_shape.h"
#include "planner/units/quantity.h"

#include <optional>
#include <span>
#include <vector>

namespace furrow {

enum class SnapKind { Vertex, Edge, RightAngle, Straight };

/// The place that the pointer snaps to, and the reason.
struct Snap {
    Point place;
    std::vector<SnapKind> kinds;  ///< empty if it does not move; two where two lines cross
    /// Lines to show: from the vertex of the angle to the place.
    std::vector<Point> from;

    bool isSnapped() const { return !kinds.empty(); }
};

/// A line that a place may snap to.
struct SnapLine {
    Point through;
    Point along;  ///< of length 1
    SnapKind kind = SnapKind::RightAngle;
};

/// The lines on which the edge to a new or moved vertex makes a right angle with the edge before it, or
/// continues it straight. `anchor` is the vertex beside it, `before` the one beyond that.
std::vector<SnapLine> angleLines(Point anchor, Point before);

/// Snaps a place to something within reach: the nearest vertex, else a crossing of two of the lines or of a
/// line and an edge, else the nearest line or edge.
///
/// @param except  a vertex that is being moved: nothing snaps to it or to its edges
/// Cost: O(n) for n vertices and few lines.
Snap snapped(const FieldShape& shape, Point place, Length reach, std::span<const SnapLine> lines,
             std::optional<std::pair<OutlineId, std::size_t>> except = std::nullopt);

}  // namespace furrow
