#pragma once

#include "ui/map/mesh.h"

#include <vector>

namespace furrow {

/// Triangles that fill what lies inside an odd number of these rings. Ring directions do not matter; rings
/// may touch or share edges. Where rings cross, the fill is off by less than the band in which they do.
///
/// A scan line runs over the distinct heights of the vertices; the strip between two neighbouring crossings
/// grows downwards as long as it keeps its two edges, and is then closed as a trapezoid.
/// Cost: O(n (log n + k)) for n vertices and k edges across one height.
FillMesh evenOddTriangles(const std::vector<std::vector<MapPoint>>& rings);

}  // namespace furrow
