#pragma once

#include "planner/gdal/vector_feature.h"

#include <span>
#include <string>
#include <string_view>

namespace furrow {

// The attributes that are asked of every vector file, and what is in them.

std::span<const std::string_view> attributeNames();

/// Of one of these names; empty where the feature has none.
const std::string& attribute(const VectorFeature& feature, std::string_view name);

/// The names that files use for these, in order of preference; capitals do not matter.
inline constexpr std::string_view kLongitudeNames[] = {"lon", "lng", "long", "longitude", "lon_deg", "x"};
inline constexpr std::string_view kLatitudeNames[] = {"lat", "latitude", "lat_deg", "y"};
inline constexpr std::string_view kWktNames[] = {"wkt",      "geom",    "geometry",
                                                 "the_geom", "polygon", "boundary"};

/// The first of these attributes that is there; empty where none is.
std::string firstAttribute(const VectorFeature& feature, std::span<const std::string_view> names);

std::string idOf(const VectorFeature& feature);
std::string nameOf(const VectorFeature& feature);

}  // namespace furrow
