#include "planner/io/formats/geojson/geojson_shapes.h"

#include <utility>

namespace furrow {

namespace {

Json position(GeoPoint point) {
    return Json::array({point.lonDeg, point.latDeg});
}

Json ringCoordinates(const GeoRing& ring) {
    Json coordinates = Json::array();
    for (const GeoPoint& point : ring) {
        coordinates.push_back(position(point));
    }
    coordinates.push_back(position(ring.front()));
    return coordinates;
}

Json polygonCoordinates(const GeoPolygon& polygon) {
    Json rings = Json::array({ringCoordinates(polygon.outer)});
    for (const GeoRing& hole : polygon.holes) {
        rings.push_back(ringCoordinates(hole));
    }
    return rings;
}

}  // namespace

Json polygonGeometry(const std::vector<GeoPolygon>& polygons) {
    if (polygons.size() == 1) {
        return {{"type", "Polygon"}, {"coordinates", polygonCoordinates(polygons.front())}};
    }
    Json parts = Json::array();
    for (const GeoPolygon& polygon : polygons) {
        parts.push_back(polygonCoordinates(polygon));
    }
    return {{"type", "MultiPolygon"}, {"coordinates", std::move(parts)}};
}

Json lineGeometry(const GeoRing& line) {
    Json coordinates = Json::array();
    for (const GeoPoint& point : line) {
        coordinates.push_back(position(point));
    }
    return {{"type", "LineString"}, {"coordinates", std::move(coordinates)}};
}

Json pointGeometry(GeoPoint point) {
    return {{"type", "Point"}, {"coordinates", position(point)}};
}

Json geoJsonFeature(std::string_view kind, Json properties, Json geometry) {
    Json all{{"kind", kind}};
    all.update(properties);
    return {{"type", "Feature"}, {"properties", std::move(all)}, {"geometry", std::move(geometry)}};
}

void addFieldFeatures(const FieldSource& source, Area area, Json& features) {
    const auto add = [&features](std::string_view kind, Json properties, Json geometry) {
        features.push_back(geoJsonFeature(kind, std::move(properties), std::move(geometry)));
    };
    add("field",
        {{"id", source.id},
         {"name", source.name},
         {"area_m2", area.si()},
         {"boundary_accuracy_m", source.boundaryAccuracy.si()}},
        polygonGeometry(source.parts));
    for (const Obstacle& obstacle : source.obstacles) {
        Json about{
            {"name", obstacle.name}, {"passable", obstacle.passable}, {"buffer_m", obstacle.buffer.si()}};
        if (obstacle.overhang != Length{}) {
            about["overhang_m"] = obstacle.overhang.si();
        }
        add("obstacle", std::move(about), polygonGeometry({obstacle.outline}));
    }
    for (const Gate& gate : source.gates) {
        add("gate", {{"name", gate.name}, {"width_m", gate.width.si()}}, pointGeometry(gate.position));
    }
}

std::string geoJsonText(Json features) {
    return Json{{"type", "FeatureCollection"}, {"features", std::move(features)}}.dump(
               -1, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

}  // namespace furrow
