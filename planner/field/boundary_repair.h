#pragma once

#include "planner/core/result.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <string>
#include <vector>

namespace furrow {

/// Polygons that follow the rules of simple features, in both coordinate systems, and the repairs made.
struct RepairedBoundary {
    std::vector<GeoPolygon> geo;  ///< the given points, unless something had to be moved
    MultiPolygon local;
    std::vector<Note> repairs;
};

/// Makes repairs that are obvious and refuses the rest; see Field::create for the list. Parts that are
/// slivers beside the rest of the land are left out.
///
/// @param parts  finite points inside WGS84
/// @param what   its name in messages: "the boundary", "obstacle 'pond'"
Result<RepairedBoundary> repairBoundary(const std::vector<GeoPolygon>& parts, const LocalFrame& frame,
                                        const std::string& what, const JobContext& job);

/// The same for obstacles. No part is left out, however small.
Result<RepairedBoundary> repairObstacle(const GeoPolygon& outline, const LocalFrame& frame,
                                        const std::string& what, const JobContext& job);

}  // namespace furrow
