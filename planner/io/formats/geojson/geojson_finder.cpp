#include "planner/io/formats/geojson/geojson.h"

#include "planner/core/json_text.h"
#include "planner/io/files/json_values.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

namespace furrow {

namespace {

using nlohmann::json;

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
    explicit FeatureContent(ReceivedContent& found) : found_{found} {}

    void take(const json& document) {
        if (textOf(memberOf(document, "type")) != "FeatureCollection" ||
            !memberOf(document, "features").is_array()) {
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
        const json& properties = memberOf(feature, "properties");
        const json& geometry = memberOf(feature, "geometry");
        const json& coordinates = memberOf(geometry, "coordinates");
        const std::string kind = textOf(memberOf(properties, "kind"));
        const std::string type = textOf(memberOf(geometry, "type"));
        const std::string name = textOf(memberOf(properties, "name"));
        if (type == "Point") {
            found_.points.push_back({numberAt(coordinates, 0), numberAt(coordinates, 1)});
        } else if (type == "LineString" && kind == "path") {
            segments_.numbers.push_back(wholeOf(memberOf(properties, "order")));
            for (const GeoPoint& point : lonLat(coordinates)) {
                path_.samples.push_back({.geo = point});
            }
        } else if (type == "LineString" && kind == "headland_pass") {
            std::ranges::copy(lonLat(coordinates), std::back_inserter(found_.points));
        } else if (type == "LineString") {
            const json& width = memberOf(properties, "width_m");
            if (kind == "swath") {
                swaths_.numbers.push_back(wholeOf(memberOf(properties, "order")));
            }
            found_.lines.push_back(
                {.name = kind == "swath" ? "swath" : name,
                 .points = lonLat(coordinates),
                 .widthM = width.is_number() ? std::optional{width.get<double>()} : std::nullopt});
        } else if (type == "Polygon" || type == "MultiPolygon") {
            addAreas(kind, name, type == "Polygon" ? json::array({coordinates}) : coordinates,
                     kind == "field" ? memberOf(properties, "area_m2") : json{});
        } else {
            found_.faults.push_back(cannotBeRead());
        }
    }

    void addAreas(const std::string& kind, const std::string& name, const json& polygons,
                  const json& stated) {
        for (const json& polygon : polygons) {
            found_.areas.push_back({.kind = kind == "field"      ? ReceivedArea::Kind::Field
                                            : kind == "obstacle" ? ReceivedArea::Kind::Obstacle
                                                                 : ReceivedArea::Kind::Other,
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

    ReceivedContent& found_;
    ReceivedNumbers segments_;
    ReceivedNumbers swaths_;
    ReceivedPath path_;
};

}  // namespace

std::vector<ReceivedContent> findGeoJson(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        ReceivedContent& found = all.emplace_back(
            ReceivedContent{.file = file.path, .winding = ReceivedContent::Winding::OuterLeft});
        const json document = jsonOrDiscarded<json>(file.bytes);
        if (document.is_discarded()) {
            found.faults.push_back(isNot("JSON"));
            continue;
        }
        FeatureContent{found}.take(document);
    }
    return all;
}

}  // namespace furrow
