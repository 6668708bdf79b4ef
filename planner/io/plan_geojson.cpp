#include "planner/io/plan_geojson.h"

#include "planner/geometry/geos_bridge.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace furrow {

namespace {

using Json = nlohmann::ordered_json;

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

/// A Polygon for one part, a MultiPolygon for several.
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

class PlanWriter {
public:
    explicit PlanWriter(const Plan& plan) : plan_{plan}, frame_{plan.field().frame()} {}

    std::string write() {
        addField();
        addAreas();
        addCells();
        addHeadlandPasses();
        addSwaths();
        addPath();
        addMissed();
        addFindings();
        return Json{{"type", "FeatureCollection"}, {"features", std::move(features_)}}.dump(
                   -1, ' ', false, Json::error_handler_t::replace) +
               "\n";
    }

private:
    void add(std::string_view kind, Json properties, Json geometry) {
        Json all{{"kind", kind}};
        all.update(properties);
        features_.push_back(
            {{"type", "Feature"}, {"properties", std::move(all)}, {"geometry", std::move(geometry)}});
    }

    std::vector<GeoPolygon> inWgs84(const MultiPolygon& polygons) const {
        std::vector<GeoPolygon> geo;
        for (const Polygon& polygon : polygons) {
            geo.push_back(frame_.toGeo(polygon));
        }
        return geo;
    }

    void addField() {
        const FieldSource& source = plan_.field().source();
        add("field", {{"id", source.id}, {"name", source.name}, {"area_m2", plan_.field().area().si()},
             {"boundary_accuracy_m", source.boundaryAccuracy.si()}},
            polygonGeometry(source.parts));
        for (const Obstacle& obstacle : source.obstacles) {
            add("obstacle",
                {{"name", obstacle.name},
                 {"passable", obstacle.passable},
                 {"buffer_m", obstacle.buffer.si()}},
                polygonGeometry({obstacle.outline}));
        }
        for (const Gate& gate : source.gates) {
            add("gate", {{"name", gate.name}, {"width_m", gate.width.si()}}, pointGeometry(gate.position));
        }
    }

    void addAreas() {
        const Headland& headland = plan_.headland;
        if (headland.width > metres(0.0)) {
            const auto strip = difference(plan_.field().workable(), headland.mainland, {});
            if (strip && !strip->empty()) {
                add("headland", {{"width_m", headland.width.si()}, {"passes", headland.passes}},
                    polygonGeometry(inWgs84(*strip)));
            }
        }
        add("mainland", Json::object(), polygonGeometry(inWgs84(headland.mainland)));
    }

    std::size_t cellOf(std::size_t swath) const {
        const auto& cells = plan_.cells.cells;
        return static_cast<std::size_t>(std::ranges::find_if(cells, [swath](const Cell& cell) {
                                            return std::ranges::binary_search(cell.swaths, swath);
                                        }) -
                                        cells.begin());
    }

    void addCells() {
        for (std::size_t i = 0; i < plan_.cells.cells.size(); ++i) {
            add("cell", {{"number", i}}, polygonGeometry(inWgs84(plan_.cells.cells[i].outline)));
        }
    }

    void addSwaths() {
        for (std::size_t order = 0; order < plan_.route.steps.size(); ++order) {
            const RouteStep& step = plan_.route.steps[order];
            const Swath& swath = plan_.swaths.swaths[step.swath];
            add("swath",
                {{"number", swath.number},
                 {"order", order},
                 {"cell", cellOf(step.swath)},
                 {"width_m", swath.width.si()},
                 {"tramline", swath.tramline}},
                lineGeometry(frame_.toGeo(drivenMiddle(step, plan_.swaths))));
        }
    }

    /// As driven: one line for each stretch of a pass that is worked without a break.
    void addHeadlandPasses() {
        int order = 0;
        for (const PathSegment& segment : plan_.path.segments) {
            if (segment.kind == SegmentKind::HeadlandPass) {
                add("headland_pass",
                    {{"order", order++},
                     {"ring", segment.number - 1},
                     {"width_m", plan_.request.machine.operatingWidth().si()}},
                    lineGeometry(frame_.toGeo(lineOf(segment))));
            }
        }
    }

    static Polyline lineOf(const PathSegment& segment) {
        Polyline line;
        for (const PathSample& sample : segment.samples) {
            line.push_back(sample.position);
        }
        return line;
    }

    void addPath() {
        for (std::size_t order = 0; order < plan_.path.segments.size(); ++order) {
            const PathSegment& segment = plan_.path.segments[order];
            Json properties{{"order", order}, {"segment", segmentKindId(segment.kind)}};
            if (segment.kind == SegmentKind::Turn) {
                properties["turn_type"] = segment.turnType;
            }
            properties["gear"] = static_cast<int>(segment.gear);
            properties["implement_down"] = segment.implementDown;
            properties["machine"] = 0;
            properties["drivable"] = segment.drivable;
            if (!segment.drivable) {
                properties["reason"] = segment.reason;
            }
            add("path", std::move(properties), lineGeometry(frame_.toGeo(lineOf(segment))));
        }
    }

    void addMissed() {
        for (const Polygon& polygon : plan_.audit.missedAreas) {
            add("missed", {{"area_m2", area(polygon).si()}}, polygonGeometry({frame_.toGeo(polygon)}));
        }
    }

    void addFindings() {
        for (const Finding& finding : plan_.findings) {
            add("finding",
                {{"severity", finding.severity == Severity::Blocking ? "blocking" : "note"},
                 {"finding", finding.kind},
                 {"text", finding.text},
                 {"suggestion", finding.suggestion}},
                pointGeometry(frame_.toGeo(finding.place)));
        }
    }

    const Plan& plan_;
    const LocalFrame& frame_;
    Json features_ = Json::array();
};

}  // namespace

std::string planGeoJson(const Plan& plan) {
    return PlanWriter{plan}.write();
}

}  // namespace furrow
