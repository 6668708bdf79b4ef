#pragma once

#include "planner/geometry/box_tree.h"
#include "planner/headland/headland.h"

#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// Strips along edges, searchable by place. Immutable.
class EdgeStrips {
public:
    explicit EdgeStrips(std::vector<EdgeStrip> strips);

    /// One strip for each edge of the polygons, all of the same width.
    static std::vector<EdgeStrip> along(const MultiPolygon& polygons, Length width, int passes);

    const std::vector<EdgeStrip>& all() const { return strips_; }
    /// The strip of the edge nearest to a point. At least one strip must exist. Cost: O(log n).
    std::size_t nearest(Point point) const;
    /// The strip of the first edge straight ahead of a pose, within this length.
    std::optional<std::size_t> ahead(const Pose& pose, Length within) const;

private:
    std::vector<EdgeStrip> strips_;
    BoxTree tree_;
};

/// The field less the strips along its edges. A strip is round at the ends of its edge. Cost: one GEOS buffer
/// for each different width. Cancelled.
Result<MultiPolygon> withoutStrips(const MultiPolygon& workable, std::span<const EdgeStrip> strips,
                                   const JobContext& job);

}  // namespace furrow
