#include "planner/io/formats/geojson/geojson.h"

#include "planner/io/formats/geojson/geojson_shapes.h"
#include "planner/io/formats/geojson/plan_geojson.h"
#include "planner/units/angle.h"

#include <utility>

namespace furrow {

namespace {

std::string fieldsGeoJson(const ExportJob& job) {
    Json features = Json::array();
    for (const FieldContent& content : job.fields) {
        addFieldFeatures(content.field, content.statedArea(), features);
    }
    for (const FieldContent& content : job.fields) {
        if (!content.mainland.empty()) {
            features.push_back(geoJsonFeature("mainland", Json::object(), polygonGeometry(content.mainland)));
        }
        for (const GuidanceLine& line : content.lines) {
            const GeoRing points = drawn(line, metres(100.0));
            if (points.size() < 2) {
                continue;
            }
            Json properties{{"name", line.name}, {"guidance", guidanceKindId(line.kind)}};
            if (line.width) {
                properties["width_m"] = line.width->si();
            }
            if (line.bearing) {
                properties["bearing"] = inDegrees(*line.bearing);
            }
            features.push_back(geoJsonFeature("guidance", std::move(properties), lineGeometry(points)));
        }
    }
    return geoJsonText(std::move(features));
}

}  // namespace

Result<FormatFiles> writeGeoJson(const ExportJob& job) {
    FormatFiles made;
    if (job.plan != nullptr) {
        made.files.push_back({"plan.geojson", [&plan = *job.plan] { return planGeoJson(plan); }});
    } else {
        made.files.push_back({"fields.geojson", [text = fieldsGeoJson(job)] { return text; }});
    }
    return made;
}

}  // namespace furrow
