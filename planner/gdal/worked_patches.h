#pragma once

#include "planner/core/geo_point.h"
#include "planner/core/result.h"
#include "planner/jobs/job.h"

#include <filesystem>
#include <vector>

namespace furrow {

/// The patches of pixels of a GeoTIFF or PNG that are worked (not 0, not the file's value for nothing, not
/// transparent), with what they enclose that is not as holes. Outlines follow the pixels and are smoothed by
/// at most three quarters of one; those that are smoothed away are left out.
///
/// @return in WGS84. ReadFailed: damaged. InputRefused: no place on Earth, above 100 million pixels.
/// Cancelled. Cost: linear in the pixels.
Result<std::vector<GeoPolygon>> workedPatches(const std::filesystem::path& path, const JobContext& job);

}  // namespace furrow
