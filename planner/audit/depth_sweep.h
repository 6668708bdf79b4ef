#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace furrow {

// The areas that many polygons cover once, twice, or not at all, without building their union. A line moves
// over all edges at once. Between two of their ends and crossings, everything is a row of trapezoids.

inline constexpr std::size_t kMostLayers = 8;

/// The number of polygons of each layer over a place.
using Depths = std::array<std::int32_t, kMostLayers>;

/// Polygons in layers, rings in metres.
class LayeredPolygons {
public:
    /// @param layer  below kMostLayers
    /// @param ring   counter-clockwise adds 1 to the depth inside, clockwise subtracts 1
    void add(std::size_t layer, std::span<const Point> ring);
    void add(std::size_t layer, const MultiPolygon& polygons);
    /// The same as add, for a ring next to the one added before. A side that both share, in opposite
    /// directions, changes no depth and is left out. So the cost of a strip of such rings is that of its
    /// outline.
    void addNext(std::size_t layer, std::span<const Point> ring);

    struct Edge {
        Point from;
        Point to;
        std::uint8_t layer = 0;
    };
    const std::vector<Edge>& edges() const { return edges_; }

private:
    std::vector<Edge> edges_;
    std::size_t last_ = 0;     ///< first edge of the ring that addNext added last
    std::vector<Edge> added_;  ///< by addNext now
};

/// The requested regions, up to 32, distinguished by the depths.
struct DepthRegions {
    /// Bit i is set if a place with these depths belongs to region i. 0 for places without polygons.
    std::uint32_t (*at)(const Depths& depths) = nullptr;
    std::size_t count = 0;
    std::uint32_t traced = 0;  ///< bits of the regions wanted as polygons, not only as areas
};

struct MeasuredRegion {
    Area area;
    MultiPolygon polygons;  ///< if traced: largest first, without those under 10 cm²
};

/// Measures regions, in their order.
///
/// @param along  unit vector; the sweep is faster if any line along it crosses few edges
/// Areas are exact except for rounding. Edges within a nanometre of each other count as one, which is less
/// than 1e-9 m² for each metre of edge. Deterministic.
/// Cost: O((n + k) m) for n edges, k crossings and m edges on a line. Cancelled.
Result<std::vector<MeasuredRegion>> measureRegions(const LayeredPolygons& polygons, Point along,
                                                   const DepthRegions& regions, const JobContext& job);

}  // namespace furrow
