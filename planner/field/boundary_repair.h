#pragma once

#include "planner/core/result.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <string>
#include <vector>

namespace furrow {

/// Polygons that follow the rules of simple features, in both coordinate systems, and what it took.
struct RepairedBoundary {
    std::vector<GeoPolygon> geo;  ///< the given points wherever nothing had to be moved
    MultiPolygon local;
    std::vector<Note> repairs;
};

/// Repairs what has one obvious repair and refuses the rest; see Field::create for the list. Parts that are slivers
/// beside the rest of the land are left out.
///
/// @param parts  finite points inside WGS84
/// @param what   what messages call it: "the boundary", "obstacle 'pond'"
Result<RepairedBoundary> repairBoundary(const std::vector<GeoPolygon>& parts, const LocalFrame& frame,
                                        const std::string& what, const JobContext& job);

/// The same of what is in the way: nothing of it is left out, however small.
Result<RepairedBoundary> repairObstacle(const GeoPolygon& outline, const LocalFrame& frame, const std::string& what,
                                        const JobContext& job);

}  // namespace furrow
