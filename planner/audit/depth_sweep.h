#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace furrow {

// Areas of what many polygons cover once, twice, or not at all, without building their union: a line moves
// over all edges at once, and between two of their ends and crossings everything is a row of trapezoids.

inline constexpr std::size_t kMostLayers = 8;

/// How many polygons of each layer lie over a place.
using Depths = std::array<std::int32_t, kMostLayers>;

/// Polygons in layers, rings in metres.
class LayeredPolygons {
public:
    /// @param layer  below kMostLayers
    /// @param ring   counter-clockwise adds to the depth inside, clockwise takes from it
    void add(std::size_t layer, std::span<const Point> ring);
    void add(std::size_t layer, const MultiPolygon& polygons);
    /// The same as add, for a ring that follows on the one added before: a side that both share, each the other way
    /// round, changes no depth and is left out. A strip of such rings costs its outline.
    void addNext(std::size_t layer, std::span<const Point> ring);

    struct Edge {
        Point from;
        Point to;
        std::uint8_t layer = 0;
    };
    const std::vector<Edge>& edges() const { return edges_; }

private:
    std::vector<Edge> edges_;
    std::size_t last_ = 0;  ///< where the edges of the ring begin that addNext has added last
};

/// What is asked for: up to 32 regions, told apart by the depths.
struct DepthRegions {
    /// Bit i is set where a place with these depths belongs to region i; 0 where nothing lies.
    std::uint32_t (*at)(const Depths& depths) = nullptr;
    std::size_t count = 0;
    std::uint32_t traced = 0;  ///< bits of those wanted as polygons, not only as areas
};

struct MeasuredRegion {
    Area area;
    MultiPolygon polygons;  ///< where traced: largest first, those under 10 cm² left out
};

/// Measures regions, in their order.
///
/// @param along  unit vector; the fewer edges any line along it crosses, the faster
/// Areas are exact but for rounding: edges within a nanometre of each other count as one, that is less than
/// 1e-9 m² for each metre of edge. Deterministic.
/// Cost: O((n + k) m) for n edges, k crossings and m edges on a line. Cancelled.
Result<std::vector<MeasuredRegion>> measureRegions(const LayeredPolygons& polygons, Point along,
                                                   const DepthRegions& regions, const JobContext& job);

}  // namespace furrow
