#include "planner/benchmarks/paper.h"
#include "resources/embedded.h"

#include <nlohmann/json.hpp>

namespace furrow {

std::vector<FieldSource> paperFields() {
    // Written by resources/paper_fields/select.py: one polygon a feature, without holes.
    const nlohmann::json collection = nlohmann::json::parse(embeddedPaperFields());
    std::vector<FieldSource> fields;
    for (const nlohmann::json& feature : collection.at("features")) {
        FieldSource field;
        field.id = feature.at("id").get<std::string>();
        field.name = field.id;
        field.origin = "paper_fields.geojson, " + field.id;
        GeoPolygon outline;
        for (const nlohmann::json& position : feature.at("geometry").at("coordinates").at(0)) {
            outline.outer.push_back({position.at(0).get<double>(), position.at(1).get<double>()});
        }
        outline.outer.pop_back();  // closed in the file
        field.parts.push_back(std::move(outline));
        fields.push_back(std::move(field));
    }
    return fields;
}

}  // namespace furrow
