#pragma once

#include "planner/geometry/polygon.h"

#include <memory>
#include <optional>
#include <vector>

namespace furrow {

struct FarthestPoint {
    Point point;
    Length distance;
};

/// A set of polygons prepared for many questions. Thread-safe.
class PreparedArea {
public:
    explicit PreparedArea(const MultiPolygon& polygons);
    ~PreparedArea();
    PreparedArea(PreparedArea&&) noexcept;
    PreparedArea& operator=(PreparedArea&&) noexcept;

    /// No point of the lines lies outside; touching the edge is allowed.
    bool covers(const std::vector<Polyline>& lines) const;
    /// The same for their convex hull: a cheaper test that says no too often.
    bool coversHullOf(const std::vector<Polyline>& lines) const;
    /// The place where the lines are farthest outside, among the ends, bends and middles of their parts
    /// outside. Empty if no part is outside.
    std::optional<FarthestPoint> farthestOutside(const std::vector<Polyline>& lines) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace furrow
