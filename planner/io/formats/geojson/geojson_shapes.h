#pragma once

#include "planner/core/geo_point.h"
#include "planner/field/field.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace furrow {

// What every writer of GeoJSON needs: geometries of RFC 7946, coordinates that read back to the same number.

using Json = nlohmann::ordered_json;

/// A Polygon for one part, a MultiPolygon for several.
Json polygonGeometry(const std::vector<GeoPolygon>& polygons);
Json lineGeometry(const GeoRing& line);
Json pointGeometry(GeoPoint point);

/// `kind` is the first of its properties.
Json geoJsonFeature(std::string_view kind, Json properties, Json geometry);

/// A field with its obstacles and gates, as features that are read back as these.
void addFieldFeatures(const FieldSource& source, Area area, Json& features);

/// The FeatureCollection.
std::string geoJsonText(Json features);

}  // namespace furrow
