#pragma once

#include "planner/plan/plan.h"

#include <string>

namespace furrow {

/// The plan as an RFC 7946 FeatureCollection in WGS84: field, obstacles, gates, headland, mainland, swaths,
/// path segments and findings, told apart by their `kind`. Coordinates read back to the same number.
std::string planGeoJson(const Plan& plan);

}  // namespace furrow
