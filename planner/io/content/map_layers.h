#pragma once

#include "planner/gdal/vector_writer.h"
#include "planner/io/content/export_job.h"
#include "planner/route/route.h"

#include <vector>

namespace furrow {

/// What every map program understands of a job: layers boundary, obstacles, gates, mainland, swaths (of a
/// plan) or guidance (without), and path. Each row says in the column `kind` what it is, in the words of
/// plan.geojson, so that it is read back as that. Layers without rows are left out.
std::vector<VectorLayer> mapLayers(const ExportJob& job);

/// A swath in WGS84 as it is driven.
GeoRing swathLine(const Plan& plan, const RouteStep& step);

/// Of a plan's path: the points of a segment in WGS84.
GeoRing pathLine(const Plan& plan, std::size_t segment);

}  // namespace furrow
