#pragma once

#include "planner/geometry/box_tree.h"
#include "planner/headland/headland.h"

#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// Strips along edges, to be found by place. Immutable.
class EdgeStrips {
public:
    explicit EdgeStrips(std::vector<EdgeStrip> strips);

    /// One for each edge of polygons, all of the same width.
    static std::vector<EdgeStrip> along(const MultiPolygon& polygons, Length width, int passes);

    const std::vector<EdgeStrip>& all() const { return strips_; }
    /// Of the edge nearest to a point. Cost: O(log n). There has to be one.
    std::size_t nearest(Point point) const;
    /// Of the first edge that is met from a pose straight ahead within this length.
    std::optional<std::size_t> ahead(const Pose& pose, Length within) const;

private:
    std::vector<EdgeStrip> strips_;
    BoxTree tree_;
};

/// What strips along their edges leave of the field; around the ends of an edge a strip is round. Cost: a GEOS buffer
/// for each width there is. Cancelled.
Result<MultiPolygon> withoutStrips(const MultiPolygon& workable, std::span<const EdgeStrip> strips,
                                   const JobContext& job);

}  // namespace furrow
