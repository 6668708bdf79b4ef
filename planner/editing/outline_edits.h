#pragma once

#include "planner/editing/field_shape.h"
#include "planner/units/quantity.h"

namespace furrow {

// An outline's points with one change. Unmoved points keep their places to the last bit.

GeoRing withVertexAt(const Outline& outline, const LocalFrame& frame, std::size_t vertex, Point place);
/// With another vertex on an edge, after its first one.
GeoRing withVertexOn(const Outline& outline, const LocalFrame& frame, std::size_t edge, Point place);
/// Empty if too few would remain: three of a ring, two of a line.
std::optional<GeoRing> withoutVertex(const Outline& outline, std::size_t vertex);

/// With an edge moved sideways, to the left of its direction if positive. Its ends slide along the edges
/// beside it. If such an edge is nearly parallel, or would reverse, the end moves straight.
GeoRing withEdgeMoved(const Outline& outline, const LocalFrame& frame, std::size_t edge, Length sideways);

/// With an edge of this length: its far end moves along it.
GeoRing withEdgeLength(const Outline& outline, const LocalFrame& frame, std::size_t edge, Length length);
/// With an edge in this heading: it rotates about its first end.
GeoRing withEdgeHeading(const Outline& outline, const LocalFrame& frame, std::size_t edge, Angle heading);

/// With all points moved.
GeoRing withAllMoved(const Outline& outline, const LocalFrame& frame, Point way);

/// A ring that runs counter-clockwise, or clockwise.
GeoRing turnedRing(GeoRing places, const LocalFrame& frame, bool counterClockwise);

/// The angle inside a ring at a vertex, or between the two edges of a line, in [0, 2 pi).
Angle cornerAngle(const Outline& outline, std::size_t vertex);

}  // namespace furrow
