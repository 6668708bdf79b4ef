#include "planner/io/formats/geojson/plan_geojson.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/io/formats/geojson/geojson_shapes.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

// What is missed is told on a grid of one of these sizes, without pieces that are smaller.
constexpr Length kPlain[] = {metres(5e-3), metres(0.02), metres(0.05)};
constexpr Area kCrumb = squareMetres(0.01);

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
        addAreas("left_on_purpose", plan_.leftOnPurpose);
        if (plan_.overhung) {
            addAreas("overhung", *plan_.overhung);
        }
        addRefillPoints();
        addMissed();
        addFindings();
        return geoJsonText(std::move(features_));
    }

private:
    void add(std::string_view kind, Json properties, Json geometry) {
        features_.push_back(geoJsonFeature(kind, std::move(properties), std::move(geometry)));
    }

    std::vector<GeoPolygon> inWgs84(const MultiPolygon& polygons) const {
        std::vector<GeoPolygon> geo;
        for (const Polygon& polygon : polygons) {
            geo.push_back(frame_.toGeo(polygon));
        }
        return geo;
    }

    void addField() { addFieldFeatures(plan_.field().source(), plan_.field().area(), features_); }

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
        return static_cast<std::size_t>(
            std::ranges::find_if(
                cells, [swath](const Cell& cell) { return std::ranges::binary_search(cell.swaths, swath); }) -
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
            if (segment.number > 0) {
                properties["number"] = segment.number;
            }
            if (segment.kind == SegmentKind::Turn) {
                properties["turn_type"] = segment.turnType;
            }
            properties["gear"] = static_cast<int>(segment.gear);
            properties["implement_down"] = segment.implementDown;
            if (segment.folded) {
                properties["folded"] = true;
            }
            if (segment.refills) {
                properties["refills"] = true;
            }
            properties["machine"] = 0;
            properties["drivable"] = segment.drivable;
            if (!segment.drivable) {
                properties["reason"] = segment.reason;
            }
            add("path", std::move(properties), lineGeometry(frame_.toGeo(lineOf(segment))));
        }
    }

    void addAreas(std::string_view kind, const MultiPolygon& polygons) {
        MultiPolygon written;
        for (const Polygon& polygon : polygons) {
            // As it was drawn, to the last digit, wherever that can be read again.
            std::ranges::move(survivesWriting(polygon) ? MultiPolygon{polygon} : plain({polygon}),
                              std::back_inserter(written));
        }
        for (const Polygon& polygon : written) {
            add(kind, {{"area_m2", area(polygon).si()}}, polygonGeometry({frame_.toGeo(polygon)}));
        }
    }

    /// With all coordinates on a grid; a union of one polygon would leave it as it is.
    static Result<MultiPolygon> snapped(const MultiPolygon& polygons, Length grid) {
        const Bounds box = bounds(polygons);
        const Point rim{1.0, 1.0};
        const Point low = box.min - rim;
        const Point high = box.max + rim;
        return intersection(polygons, {{.outer = {low, {high.x, low.y}, high, {low.x, high.y}}, .holes = {}}},
                            {}, grid);
    }

    /// Still sound when it is read in longitude and latitude, into whatever frame.
    bool survivesWriting(const Polygon& polygon) const {
        const GeoPolygon geo = frame_.toGeo(polygon);
        const auto frame = LocalFrame::centredOn(geo.outer.front());
        const auto invalid =
            frame ? findInvalidPlace({frame->toLocal(geo)}, {}) : std::unexpected(frame.error());
        return invalid && !*invalid;
    }

    /// Traced outlines touch and cross themselves by centimetres and have hairs that rounding turns inside
    /// out, which other programs refuse: on the finest grid that leaves none of these.
    MultiPolygon plain(const MultiPolygon& traced) const {
        MultiPolygon written;
        for (const Polygon& polygon : traced) {
            const auto mended = madeValid({polygon}, {});
            MultiPolygon best = mended ? *mended : MultiPolygon{polygon};
            for (const Length grid : kPlain) {
                auto onGrid = mended ? snapped(*mended, grid) : mended;
                if (onGrid && std::ranges::all_of(
                                  *onGrid, [this](const Polygon& piece) { return survivesWriting(piece); })) {
                    best = *std::move(onGrid);
                    break;
                }
            }
            std::ranges::move(best, std::back_inserter(written));
        }
        return written;
    }

    void addRefillPoints() {
        if (plan_.refill) {
            for (const Point& point : plan_.refill->points) {
                add("refill_point", Json::object(), pointGeometry(frame_.toGeo(point)));
            }
        }
    }

    void addMissed() {
        for (const Polygon& polygon : plain(plan_.audit.missedAreas)) {
            if (area(polygon) > kCrumb) {
                add("missed", {{"area_m2", area(polygon).si()}}, polygonGeometry({frame_.toGeo(polygon)}));
            }
        }
    }

    void addFindings() {
        for (const Finding& finding : plan_.findings) {
            add("finding",
                {{"severity", finding.severity == Severity::Blocking ? "blocking" : "note"},
                 {"finding", kindId(finding)},
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
