#pragma once

#include "planner/gdal/vector_feature.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace furrow {

// The attributes that are asked of every vector file, and what is in them.

/// The names that files use for these, in order of preference; capitals do not matter.
inline constexpr std::string_view kLongitudeNames[] = {"lon", "lng", "long", "longitude", "lon_deg", "x"};
inline constexpr std::string_view kLatitudeNames[] = {"lat", "latitude", "lat_deg", "y"};
inline constexpr std::string_view kWktNames[] = {"wkt",      "geom",    "geometry",
                                                 "the_geom", "polygon", "boundary"};
inline constexpr std::string_view kIdNames[] = {"id",        "field_id", "fieldid",
                                                "parcel_id", "localid",  "gml_id"};
inline constexpr std::string_view kNameNames[] = {"field_name", "fieldname", "name", "field"};
/// Furrow's own.
inline constexpr std::string_view kOtherNames[] = {
    "kind", "passable", "buffer_m", "overhang_m", "width_m", "boundary_accuracy_m",
    "part", "ring",     "guidance", "bearing",    "layer"};

/// One of kOtherNames. Any other is refused when the program is built.
class AttributeName {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): a name is written as what it is
    consteval AttributeName(const char* name) : name_{name} {
        if (std::ranges::find(kOtherNames, name_) == std::ranges::end(kOtherNames)) {
            throw name;
        }
    }

    std::string_view text() const { return name_; }

private:
    std::string_view name_;
};

/// All of these names.
std::span<const std::string_view> attributeNames();

/// Empty where the feature has none of this name.
const std::string& attribute(const VectorFeature& feature, AttributeName name);

/// The first of these attributes that is there; empty where none is.
std::string firstAttribute(const VectorFeature& feature, std::span<const std::string_view> names);

std::string idOf(const VectorFeature& feature);
std::string nameOf(const VectorFeature& feature);

}  // namespace furrow
