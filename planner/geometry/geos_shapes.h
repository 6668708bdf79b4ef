#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <geos_c.h>

#include <functional>
#include <memory>
#include <vector>

// Internal to the sources that call GEOS: its handle of each thread, shapes as GEOS has them, and cancelling.

namespace furrow::geos {

/// The context of this thread.
GEOSContextHandle_t handle();

struct GeometryDeleter {
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(handle(), geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, GeometryDeleter>;

Geometry toGeos(const Polygon& polygon);
Geometry toGeos(const MultiPolygon& polygons);
Geometry toGeos(const std::vector<Polyline>& lines);
/// All polygons of a shape, the largest first. Outer rings are counter-clockwise.
MultiPolygon fromGeos(const GEOSGeometry* geometry);
/// The points of a line or a point.
std::vector<Point> pointsOf(const GEOSGeometry* geometry);

/// Runs one GEOS operation under the job's stop token. InputRefused: it gave nothing. Cancelled.
Result<Geometry> run(const JobContext& job, const std::function<GEOSGeometry*()>& operation);

}  // namespace furrow::geos
