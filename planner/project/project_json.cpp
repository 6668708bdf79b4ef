#include "planner/project/project_json.h"

#include "planner/machine/machine_file.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/review_json.h"

#include <algorithm>

namespace furrow {

namespace {

// --- Geometry ---------------------------------------------------------------------------------------

OrderedJson positionOf(GeoPoint point) {
    return OrderedJson::array({point.lonDeg, point.latDeg});
}

GeoPoint pointOf(const OrderedJson& position) {
    return {position.at(0).get<double>(), position.at(1).get<double>()};
}

OrderedJson ringOf(const GeoRing& ring) {
    OrderedJson positions = OrderedJson::array();
    for (const GeoPoint& point : ring) {
        positions.push_back(positionOf(point));
    }
    if (!ring.empty()) {
        positions.push_back(positionOf(ring.front()));
    }
    return positions;
}

GeoRing ringFrom(const OrderedJson& positions) {
    GeoRing ring;
    for (const OrderedJson& position : positions) {
        ring.push_back(pointOf(position));
    }
    if (ring.size() > 1 && ring.front() == ring.back()) {
        ring.pop_back();
    }
    return ring;
}

OrderedJson ringsOf(const GeoPolygon& polygon) {
    OrderedJson rings = OrderedJson::array({ringOf(polygon.outer)});
    for (const GeoRing& hole : polygon.holes) {
        rings.push_back(ringOf(hole));
    }
    return rings;
}

GeoPolygon polygonFrom(const OrderedJson& rings) {
    GeoPolygon polygon;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (i == 0) {
            polygon.outer = ringFrom(rings[i]);
        } else {
            polygon.holes.push_back(ringFrom(rings[i]));
        }
    }
    return polygon;
}

OrderedJson geometryOf(const std::vector<GeoPolygon>& polygons) {
    if (polygons.size() == 1) {
        return {{"type", "Polygon"}, {"coordinates", ringsOf(polygons.front())}};
    }
    OrderedJson parts = OrderedJson::array();
    for (const GeoPolygon& polygon : polygons) {
        parts.push_back(ringsOf(polygon));
    }
    return {{"type", "MultiPolygon"}, {"coordinates", std::move(parts)}};
}

std::vector<GeoPolygon> polygonsFrom(const OrderedJson& geometry) {
    std::vector<GeoPolygon> polygons;
    const OrderedJson& coordinates = geometry.at("coordinates");
    if (geometry.at("type") == "Polygon") {
        polygons.push_back(polygonFrom(coordinates));
    } else {
        for (const OrderedJson& rings : coordinates) {
            polygons.push_back(polygonFrom(rings));
        }
    }
    return polygons;
}

// --- Features ---------------------------------------------------------------------------------------

/// Members of a feature and of its properties that are not known, as one text.
std::string othersOf(const OrderedJson& feature, std::initializer_list<std::string_view> known) {
    OrderedJson others = OrderedJson::object();
    const std::string members = otherMembers(feature, {"type", "properties", "geometry"});
    const std::string properties = otherMembers(feature.at("properties"), known);
    if (!members.empty()) {
        others["members"] = OrderedJson::parse(members);
    }
    if (!properties.empty()) {
        others["properties"] = OrderedJson::parse(properties);
    }
    return others.empty() ? std::string{} : textOf(others);
}

OrderedJson featureOf(OrderedJson properties, OrderedJson geometry, std::string_view others) {
    OrderedJson feature{
        {"type", "Feature"}, {"properties", std::move(properties)}, {"geometry", std::move(geometry)}};
    if (!others.empty()) {
        const OrderedJson added = OrderedJson::parse(others);
        if (added.contains("properties")) {
            addMembers(feature["properties"], textOf(added["properties"]));
        }
        if (added.contains("members")) {
            addMembers(feature, textOf(added["members"]));
        }
    }
    return feature;
}

std::string_view at(const std::vector<std::string>& texts, std::size_t index) {
    return index < texts.size() ? std::string_view{texts[index]} : std::string_view{};
}

Length lengthIn(const OrderedJson& properties, const char* key) {
    return metres(properties.value(key, 0.0));
}

// --- Plans ------------------------------------------------------------------------------------------

OrderedJson settingsOf(const Settings& settings) {
    OrderedJson json = OrderedJson::object();
    for (const Parameter* parameter : allParameters()) {
        if (!settings.isSet(*parameter)) {
            continue;
        }
        const SettingValue value = settings.value(*parameter);
        OrderedJson& member = json[std::string{parameter->key}];
        if (const auto* number = std::get_if<double>(&value)) {
            member = *number;
        } else if (const auto* flag = std::get_if<bool>(&value)) {
            member = *flag;
        } else {
            member = settingText(value);
        }
    }
    return json;
}

Result<void> applySetting(Settings& settings, const std::string& key, const OrderedJson& value) {
    const auto parameter = findParameter(key);
    if (!parameter) {
        return std::unexpected(parameter.error());
    }
    if (value.is_boolean()) {
        return settings.set(**parameter, value.get<bool>());
    }
    if (value.is_number()) {
        return settings.set(**parameter, value.get<double>());
    }
    const std::string text = value.is_string() ? value.get<std::string>() : textOf(value);
    return settings.set(**parameter, text == "auto" ? SettingValue{Auto{}} : SettingValue{text});
}

constexpr const char* kWorkOrder = "work_order";

OrderedJson planOf(const FieldPlan& plan) {
    OrderedJson json{{"id", plan.id}, {"name", plan.name}, {"season", plan.season}};
    json["machine"] = OrderedJson::parse(machineJson(plan.machine.spec()));
    json["settings"] = settingsOf(plan.settings);
    if (!plan.review.empty()) {
        json["review"] = reviewJson(plan.review);
    }
    if (plan.order != WorkOrder{}) {
        json[kWorkOrder] = OrderedJson::parse(workOrderJson(plan.order));
    }
    if (!plan.others.empty()) {
        const OrderedJson others = OrderedJson::parse(plan.others);
        for (const char* object : {"machine", "settings"}) {
            if (others.contains(object)) {
                addMembers(json[object], textOf(others[object]));
            }
        }
        addMembers(json, plan.others);
    }
    return json;
}

FieldPlan planFrom(const OrderedJson& json, Notes& notes) {
    FieldPlan plan{.id = json.at("id").get<std::string>(),
                   .name = json.value("name", ""),
                   .season = json.value("season", ""),
                   .machine = machineLibrary().front(),
                   .settings = {},
                   .review = json.contains("review") ? reviewFrom(json.at("review")) : Review{},
                   .order = {},
                   .others = {}};
    OrderedJson others = OrderedJson::object();
    addMembers(others, otherMembers(json, {"id", "name", "season", "field", "machine", "settings", "review",
                                           kWorkOrder}));
    const std::string called = plan.name.empty() ? plan.id : plan.name;

    OrderedJson known = OrderedJson::object();
    OrderedJson unknown = OrderedJson::object();
    const OrderedJson machineMembers = json.value("machine", OrderedJson::object());
    for (const auto& [key, value] : machineMembers.items()) {
        (std::ranges::contains(machineKeys(), key, &MachineKey::key) ? known : unknown)[key] = value;
    }
    if (const auto machine = parseMachine(textOf(known), called)) {
        plan.machine = *machine;
    } else if (!known.empty()) {
        notes.push_back(message("{}: {} ({}); the plan is made with {} until then", machine.error().where,
                                machine.error().what, machine.error().remedy, plan.machine.name()));
        // Beside the one in its place, which has the same keys.
        others["refused_machine"] = known;
    }
    if (!unknown.empty()) {
        others["machine"] = unknown;
    }

    OrderedJson unused = OrderedJson::object();
    const OrderedJson settings = json.value("settings", OrderedJson::object());
    for (const auto& [key, value] : settings.items()) {
        if (const auto applied = applySetting(plan.settings, key, value); !applied) {
            unused[key] = value;
            notes.push_back(message("{}: the setting {} is not used: {}", called, key, applied.error().what));
        }
    }
    if (!unused.empty()) {
        others["settings"] = unused;
    }
    if (json.contains(kWorkOrder)) {
        // One that cannot be read stays in the file as it is.
        if (const auto order = parseWorkOrder(textOf(json.at(kWorkOrder)), called)) {
            plan.order = *order;
        } else {
            others[kWorkOrder] = json.at(kWorkOrder);
            notes.push_back(message("{}: its work order is not used: {}", called, order.error().what));
        }
    }
    plan.others = others.empty() ? std::string{} : textOf(others);
    return plan;
}

// --- Imagery ----------------------------------------------------------------------------------------

OrderedJson layerOf(const ImageryLayer& layer) {
    OrderedJson json{
        {"path", layer.path}, {"name", layer.name}, {"visible", layer.visible}, {"opacity", layer.opacity}};
    if (layer.rowsFromSouth) {
        json["rows_from_south"] = *layer.rowsFromSouth;
    }
    addMembers(json, layer.others);
    return json;
}

ImageryLayer layerFrom(const OrderedJson& json) {
    ImageryLayer layer{
        .path = json.at("path").get<std::string>(),
        .name = json.value("name", ""),
        .visible = json.value("visible", true),
        .opacity = std::clamp(json.value("opacity", 1.0), 0.0, 1.0),
        .rowsFromSouth = {},
        .others = otherMembers(json, {"path", "name", "visible", "opacity", "rows_from_south"})};
    if (json.contains("rows_from_south")) {
        layer.rowsFromSouth = json.at("rows_from_south").get<bool>();
    }
    return layer;
}

constexpr const char* kEdgeHeadlands = "edge_headlands";
constexpr const char* kEdgeOverhangs = "edge_overhangs";

/// None are left out of the file.
void addEdgeWidths(OrderedJson& properties, const char* key, const std::vector<EdgeWidth>& widths) {
    for (const EdgeWidth& own : widths) {
        properties[key].push_back(
            {{"part", own.part}, {"ring", own.ring}, {"edge", own.edge}, {"width_m", own.width.si()}});
    }
}

std::vector<EdgeWidth> edgeWidthsIn(const OrderedJson& properties, const char* key) {
    std::vector<EdgeWidth> widths;
    for (const OrderedJson& own : properties.value(key, OrderedJson::array())) {
        widths.push_back({.part = own.at("part").get<std::size_t>(),
                          .ring = own.at("ring").get<std::size_t>(),
                          .edge = own.at("edge").get<std::size_t>(),
                          .width = lengthIn(own, "width_m")});
    }
    return widths;
}

}  // namespace

OrderedJson featuresOf(const ProjectField& field) {
    const FieldSource& source = *field.source;
    OrderedJson features = OrderedJson::array();
    OrderedJson properties{{"kind", "field"},         {"field", field.id},
                           {"id", source.id},         {"name", source.name},
                           {"origin", source.origin}, {"boundary_accuracy_m", source.boundaryAccuracy.si()}};
    addEdgeWidths(properties, kEdgeHeadlands, source.edgeHeadlands);
    addEdgeWidths(properties, kEdgeOverhangs, source.edgeOverhangs);
    features.push_back(featureOf(std::move(properties), geometryOf(source.parts), field.others));
    for (std::size_t i = 0; i < source.obstacles.size(); ++i) {
        const Obstacle& obstacle = source.obstacles[i];
        OrderedJson about{{"kind", "obstacle"},
                          {"field", field.id},
                          {"name", obstacle.name},
                          {"passable", obstacle.passable},
                          {"buffer_m", obstacle.buffer.si()}};
        if (obstacle.overhang != Length{}) {
            about["overhang_m"] = obstacle.overhang.si();
        }
        features.push_back(
            featureOf(std::move(about), geometryOf({obstacle.outline}), at(field.obstacleOthers, i)));
    }
    for (std::size_t i = 0; i < source.gates.size(); ++i) {
        const Gate& gate = source.gates[i];
        features.push_back(featureOf(
            {{"kind", "gate"}, {"field", field.id}, {"name", gate.name}, {"width_m", gate.width.si()}},
            {{"type", "Point"}, {"coordinates", positionOf(gate.position)}}, at(field.gateOthers, i)));
    }
    return features;
}

OrderedJson plansOf(const ProjectField& field) {
    OrderedJson plans = OrderedJson::array();
    for (const FieldPlan& plan : field.plans) {
        OrderedJson json = planOf(plan);
        json["field"] = field.id;
        plans.push_back(std::move(json));
    }
    return plans;
}

ProjectField fieldOf(const OrderedJson& features, const OrderedJson& plans, const FieldPlan& standard,
                     const std::string& planId, Notes& notes) {
    ProjectField field;
    FieldSource source;
    for (const OrderedJson& feature : features) {
        const OrderedJson& properties = feature.at("properties");
        const OrderedJson& geometry = feature.at("geometry");
        const std::string kind = properties.at("kind").get<std::string>();
        if (kind == "field") {
            field.id = properties.at("field").get<std::string>();
            source.id = properties.value("id", field.id);
            source.name = properties.value("name", source.id);
            source.origin = properties.value("origin", "");
            source.boundaryAccuracy = lengthIn(properties, "boundary_accuracy_m");
            source.parts = polygonsFrom(geometry);
            source.edgeHeadlands = edgeWidthsIn(properties, kEdgeHeadlands);
            source.edgeOverhangs = edgeWidthsIn(properties, kEdgeOverhangs);
            field.others = othersOf(feature, {"kind", "field", "id", "name", "origin", "boundary_accuracy_m",
                                              kEdgeHeadlands, kEdgeOverhangs});
        } else if (kind == "obstacle") {
            for (GeoPolygon& outline : polygonsFrom(geometry)) {
                source.obstacles.push_back({.name = properties.value("name", ""),
                                            .outline = std::move(outline),
                                            .passable = properties.value("passable", false),
                                            .buffer = lengthIn(properties, "buffer_m"),
                                            .overhang = lengthIn(properties, "overhang_m")});
                field.obstacleOthers.push_back(
                    othersOf(feature, {"kind", "field", "name", "passable", "buffer_m", "overhang_m"}));
            }
        } else {
            source.gates.push_back({.name = properties.value("name", ""),
                                    .position = pointOf(geometry.at("coordinates")),
                                    .width = lengthIn(properties, "width_m")});
            field.gateOthers.push_back(othersOf(feature, {"kind", "field", "name", "width_m"}));
        }
    }
    for (std::vector<std::string>* others : {&field.obstacleOthers, &field.gateOthers}) {
        while (!others->empty() && others->back().empty()) {
            others->pop_back();
        }
    }
    for (const OrderedJson& plan : plans) {
        field.plans.push_back(planFrom(plan, notes));
    }
    if (field.plans.empty()) {
        field.plans.push_back(standard);
        field.plans.back().id = planId;
    }
    field.source = std::make_shared<const FieldSource>(std::move(source));
    return field;
}

OrderedJson headOf(const Project& project) {
    OrderedJson head{{"name", project.name}};
    if (const ProjectField* field = project.field()) {
        head["current"] = {{"field", field->id}, {"plan", project.plan().id}};
    }
    head["standard"] = planOf(project.standard);
    for (const ImageryLayer& layer : project.imagery) {
        head["imagery"].push_back(layerOf(layer));
    }
    addMembers(head, project.others);
    return head;
}

void readHead(const OrderedJson& head, Project& project, Notes& notes) {
    project.name = head.value("name", "");
    if (head.contains("standard")) {
        project.standard = planFrom(head.at("standard"), notes);
    }
    project.currentField = 0;
    project.currentPlan = 0;
    if (head.contains("current")) {
        const OrderedJson& current = head.at("current");
        const std::string fieldId = current.value("field", "");
        const auto field =
            std::ranges::find_if(project.fields, [&](const auto& each) { return each->id == fieldId; });
        if (field != project.fields.end()) {
            project.currentField = static_cast<std::size_t>(field - project.fields.begin());
            const auto& plans = (*field)->plans;
            const auto plan = std::ranges::find(plans, current.value("plan", ""), &FieldPlan::id);
            project.currentPlan = plan == plans.end() ? 0 : static_cast<std::size_t>(plan - plans.begin());
        }
    }
    project.imagery.clear();
    for (const OrderedJson& layer : head.value("imagery", OrderedJson::array())) {
        project.imagery.push_back(layerFrom(layer));
    }
    project.others = otherMembers(
        head, {"format_version", "written_by", "name", "current", "standard", "imagery", "plans"});
}

}  // namespace furrow
