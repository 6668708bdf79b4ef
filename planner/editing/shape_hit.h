#pragma once

#include "planner/editing/field_shape.h"

namespace furrow {

/// The part of a field's shape at a place.
struct ShapeHit {
    enum class Kind {
        Vertex,
        Edge,
        Inside,  ///< of a hole or an obstacle
        Gate,
    };
    Kind kind = Kind::Vertex;
    OutlineId outline;
    std::size_t index = 0;  ///< vertex, edge (from vertex `index` to the next), or gate
    Point place;            ///< on it, nearest to the given place

    friend bool operator==(const ShapeHit&, const ShapeHit&) = default;
};

/// The thing within reach: a gate before a vertex before an edge, the nearest of each. Without any of them,
/// the hole or obstacle around the place. Of overlapping outlines, the later one. Cost: O(n).
std::optional<ShapeHit> hitAt(const FieldShape& shape, Point place, Length reach);

/// The part of the field around a place. Empty outside.
std::optional<std::size_t> partAt(const FieldShape& shape, Point place);

/// The nearest place on any boundary or hole. Empty without one.
std::optional<Point> nearestOnBoundary(const FieldShape& shape, Point place);

}  // namespace furrow
