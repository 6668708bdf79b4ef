#pragma once

#include "planner/editing/field_shape.h"

namespace furrow {

/// What of a field's shape a place meets.
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
    Point place;            ///< on it, nearest to the one that was asked for

    friend bool operator==(const ShapeHit&, const ShapeHit&) = default;
};

/// What is within reach: a gate before a vertex before an edge, the nearest of each; without any of them the hole
/// or obstacle around the place. Of what lies over something else, the later outline. Cost: O(n).
std::optional<ShapeHit> hitAt(const FieldShape& shape, Point place, Length reach);

/// The part of the field around a place; nothing outside.
std::optional<std::size_t> partAt(const FieldShape& shape, Point place);


/// The place on any boundary or hole that is nearest; nothing without one.
std::optional<Point> nearestOnBoundary(const FieldShape& shape, Point place);

}  // namespace furrow
