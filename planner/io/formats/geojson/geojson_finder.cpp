#include "planner/io/content/export_job.h"
#include "planner/io/content/received_content.h"

#include <nlohmann/json.hpp>

#include <array>
#include <limits>
#include <string>
#include <utility>

namespace furrow {

namespace {

using nlohmann::json;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double numberAt(const json& array, std::size_t index) {
    return array.is_array() && index < array.size() && array[index].is_number() ? array[index].get<double>() : kNan;
}

/// The value of a member; null where there is none.
const json& member(const json& object, const char* name) {
    static const json kNone;
    const auto found = object.is_object() ? object.find(name) : object.end();
    return object.is_object() && found != object.end() ? *found : kNone;
}

std::string textOf(const json& value) {
    return value.is_string() ? value.get<std::string>() : std::string{};
}

GeoRing lonLat(const json& positions) {
    GeoRing points;
    for (const json& position : positions) {
        points.push_back({numberAt(position, 0), numberAt(position, 1)});
    }
    return points;
}

GeoPolygon polygonOf(const json& rings) {
    GeoPolygon polygon;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        (i == 0 ? polygon.outer : polygon.holes.emplace_back()) = lonLat(rings[i]);
    }
    return polygon;
}

class FeatureContent {
public:
    FeatureContent(const ExportJob& job, FoundContent& found) : job_{job}, found_{found} {}

    void take(const json& document) {
        if (textOf(member(document, "type")) != "FeatureCollection" || !member(document, "features").is_array()) {
            found_.faults.push_back(isNot("FeatureCollection"));
            return;
        }
        // Readers of today take it for a mistake: WGS84 is the only one that there is.
        found_.namesCrs = !document.contains("crs");
        for (const json& feature : document["features"]) {
            addFeature(feature);
        }
        found_.orders = {std::move(segments_), std::move(swaths_)};
        if (!path_.samples.empty()) {
            found_.paths.push_back(std::move(path_));
        }
    }

private:
    void addFeature(const json& feature) {
        const json& properties = member(feature, "properties");
        const json& geometry = member(feature, "geometry");
        const json& coordinates = member(geometry, "coordinates");
        const std::string kind = textOf(member(properties, "kind"));
        const std::string type = textOf(member(geometry, "type"));
        const std::string name = textOf(member(properties, "name"));
        if (type == "Point") {
            found_.points.push_back({numberAt(coordinates, 0), numberAt(coordinates, 1)});
        } else if (type == "LineString" && kind == "path") {
            segments_.numbers.push_back(wholeOf(member(properties, "order")));
            for (const GeoPoint& point : lonLat(coordinates)) {
                path_.samples.push_back({.geo = point});
            }
        } else if (type == "LineString" && kind == "headland_pass") {
            std::ranges::copy(lonLat(coordinates), std::back_inserter(found_.points));
        } else if (type == "LineString") {
            const json& width = member(properties, "width_m");
            if (kind == "swath") {
                swaths_.numbers.push_back(wholeOf(member(properties, "order")));
            }
            found_.lines.push_back({.name = kind == "swath" ? "swath" : name,
                                    .points = lonLat(coordinates),
                                    .widthM = width.is_number() ? std::optional{width.get<double>()} : std::nullopt});
        } else if (type == "Polygon" || type == "MultiPolygon") {
            addAreas(kind, name, type == "Polygon" ? json::array({coordinates}) : coordinates,
                     kind == "field" ? member(properties, "area_m2") : json{});
        } else {
            found_.faults.push_back(cannotBeRead());
        }
    }

    void addAreas(const std::string& kind, const std::string& name, const json& polygons, const json& stated) {
        for (const json& polygon : polygons) {
            found_.areas.push_back({.kind = kind == "field"      ? FoundArea::Kind::Field
                                            : kind == "obstacle" ? FoundArea::Kind::Obstacle
                                                                 : FoundArea::Kind::Other,
                                    .name = name.empty() ? kind : name,
                                    .rings = polygonOf(polygon),
                                    // Of all parts together.
                                    .statedM2 = stated.is_number() && polygons.size() == 1
                                                    ? std::optional{stated.get<double>()}
                                                    : std::nullopt});
        }
    }

    static std::int64_t wholeOf(const json& value) {
        return value.is_number_integer() ? value.get<std::int64_t>() : -1;
    }

    const ExportJob& job_;
    FoundContent& found_;
    FoundOrder segments_;
    FoundOrder swaths_;
    FoundPath path_;
};

constexpr int kWaypoint = 16;
constexpr std::array<int, 4> kCommands = {kWaypoint, 178, 181, 194};

void addMission(const json& mission, FoundContent& found) {
    FoundOrder items{.first = 1, .numbers = {}};
    FoundPath path;
    const json& home = member(mission, "plannedHomePosition");
    found.points.push_back({numberAt(home, 1), numberAt(home, 0)});
    for (const json& item : member(mission, "items")) {
        const json& command = member(item, "command");
        const json& parameters = member(item, "params");
        const bool known = command.is_number_integer() && std::ranges::contains(kCommands, command.get<int>());
        if (!known || parameters.size() != 7) {
            found.faults.push_back(badLine(items.numbers.size() + 1));
            break;
        }
        items.numbers.push_back(static_cast<std::int64_t>(numberAt(json::array({member(item, "doJumpId")}), 0)));
        if (command.get<int>() == kWaypoint) {
            path.samples.push_back({.geo = {numberAt(parameters, 5), numberAt(parameters, 4)}});
        }
    }
    found.orders.push_back(std::move(items));
    found.paths.push_back(std::move(path));
}

/// Latitude first; an exclusion is an area of its own.
void addFences(const json& polygons, FoundContent& found) {
    for (const json& fence : polygons) {
        GeoRing ring;
        for (const json& position : member(fence, "polygon")) {
            ring.push_back({numberAt(position, 1), numberAt(position, 0)});
        }
        const bool inside = member(fence, "inclusion") == true;
        found.areas.push_back({.kind = inside ? FoundArea::Kind::Field : FoundArea::Kind::Obstacle,
                               .name = inside ? "inclusion" : "exclusion",
                               .rings = {.outer = std::move(ring), .holes = {}},
                               .statedM2 = std::nullopt});
    }
}

}  // namespace

std::vector<FoundContent> findGeoJson(std::span<const ExportedFile> files, const ExportJob& job) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        FoundContent& found =
            all.emplace_back(FoundContent{.file = file.path, .winding = FoundContent::Winding::OuterLeft});
        const json document = json::parse(file.bytes, nullptr, false);
        if (document.is_discarded()) {
            found.faults.push_back(isNot("JSON"));
            continue;
        }
        FeatureContent{job, found}.take(document);
    }
    return all;
}

std::vector<FoundContent> findGroundStationPlan(std::span<const ExportedFile> files, const ExportJob&) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path, .repeatsFirst = false});
        const json document = json::parse(file.bytes, nullptr, false);
        if (document.is_discarded() || textOf(member(document, "fileType")) != "Plan") {
            found.faults.push_back(isNot("QGroundControl plan"));
            continue;
        }
        addMission(member(document, "mission"), found);
        addFences(member(member(document, "geoFence"), "polygons"), found);
    }
    return all;
}

}  // namespace furrow
