#pragma once

#include "planner/core/result.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/polygon.h"
#include "planner/io/content/plan_error.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace furrow {

// What every reader of a written plan's files needs. Those that take JSON throw what nlohmann throws where
// members are missing or of another kind.

/// ReadFailed: not there or not readable.
Result<std::string> planFileBytes(const std::filesystem::path& path);
/// Also InputRefused: no JSON, with the place.
Result<nlohmann::json> planJson(const std::filesystem::path& path);

/// The local frame that summary.json names as `crs`. InputRefused: none.
Result<LocalFrame> planFrame(const nlohmann::json& summary, const std::filesystem::path& path);

GeoRing pointsOf(const nlohmann::json& coordinates);
/// Of a Polygon or MultiPolygon.
MultiPolygon polygonsOf(const nlohmann::json& geometry, const LocalFrame& frame);

}  // namespace furrow
