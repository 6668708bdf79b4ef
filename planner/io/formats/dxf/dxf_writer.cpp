#include "planner/io/formats/dxf/dxf.h"

#include "planner/gdal/utm_zone.h"
#include "planner/geodesy/local_frame.h"
#include "planner/io/content/map_layers.h"
#include "planner/plan/plan.h"

#include <algorithm>
#include <format>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

/// Pairs of a group code and a value, each on a line of its own: a drawing of release 12, which every program
/// reads.
class Drawing {
public:
    explicit Drawing(UtmZone zone) : zone_{zone} {}

    Result<void> polyline(const char* layer, const GeoRing& points, bool closed) {
        const auto projected = zone_.project(points);
        if (!projected) {
            return std::unexpected(projected.error());
        }
        pair(0, "POLYLINE");
        pair(8, layer);
        pair(66, "1");
        pair(70, closed ? "1" : "0");
        pair(10, "0.0");
        pair(20, "0.0");
        pair(30, "0.0");
        for (const auto& [east, north] : *projected) {
            pair(0, "VERTEX");
            pair(8, layer);
            pair(10, std::format("{:.4f}", east));
            pair(20, std::format("{:.4f}", north));
            pair(30, "0.0");
        }
        pair(0, "SEQEND");
        pair(8, layer);
        return {};
    }

    std::string text() const {
        constexpr std::pair<const char*, int> kLayers[] = {{"BOUNDARY", 30}, {"HOLE", 1},  {"OBSTACLE", 1},
                                                           {"HEADLAND", 3},  {"SWATH", 7}, {"PATH", 5}};
        std::string head;
        const auto add = [&head](int code, std::string_view value) {
            std::format_to(std::back_inserter(head), "{:3}\n{}\n", code, value);
        };
        add(0, "SECTION");
        add(2, "HEADER");
        add(9, "$ACADVER");
        add(1, "AC1009");
        add(9, "$INSUNITS");
        add(70, "6");  // metres
        add(0, "ENDSEC");
        add(0, "SECTION");
        add(2, "TABLES");
        add(0, "TABLE");
        add(2, "LAYER");
        add(70, std::to_string(std::size(kLayers)));
        for (const auto& [name, colour] : kLayers) {
            add(0, "LAYER");
            add(2, name);
            add(70, "0");
            add(62, std::to_string(colour));
            add(6, "CONTINUOUS");
        }
        add(0, "ENDTAB");
        add(0, "ENDSEC");
        add(0, "SECTION");
        add(2, "ENTITIES");
        return head + entities_ + "  0\nENDSEC\n  0\nEOF\n";
    }

private:
    void pair(int code, std::string_view value) {
        std::format_to(std::back_inserter(entities_), "{:3}\n{}\n", code, value);
    }

    UtmZone zone_;
    std::string entities_;
};

Result<void> draw(Drawing& drawing, const ExportJob& job) {
    Result<void> good;
    const auto line = [&](const char* layer, const GeoRing& points, bool closed) {
        if (good && points.size() >= 2) {
            good = drawing.polyline(layer, points, closed);
        }
    };
    const auto polygon = [&line](const char* layer, const char* holes, const GeoPolygon& drawn) {
        line(layer, drawn.outer, true);
        for (const GeoRing& hole : drawn.holes) {
            line(holes, hole, true);
        }
    };
    for (const FieldContent& content : job.fields) {
        for (const GeoPolygon& part : content.field.parts) {
            polygon("BOUNDARY", "HOLE", part);
        }
        for (const Obstacle& obstacle : content.field.obstacles) {
            polygon("OBSTACLE", "OBSTACLE", obstacle.outline);
        }
        for (const GeoPolygon& part : content.mainland) {
            polygon("HEADLAND", "HEADLAND", part);
        }
    }
    if (job.plan == nullptr) {
        for (const FieldContent& content : job.fields) {
            for (const GuidanceLine& guidance : content.lines) {
                line("SWATH", drawn(guidance, metres(100.0)), false);
            }
        }
        return good;
    }
    for (const RouteStep& step : job.plan->route.steps) {
        line("SWATH", swathLine(*job.plan, step), false);
    }
    for (std::size_t i = 0; i < job.plan->path.segments.size(); ++i) {
        line("PATH", pathLine(*job.plan, i), false);
    }
    return good;
}

}  // namespace

Result<FormatFiles> writeDxf(const ExportJob& job) {
    const UtmZone zone = UtmZone::of(middleOf(job.fields.front().field.parts));
    Drawing drawing{zone};
    if (const auto drawn = draw(drawing, job); !drawn) {
        return std::unexpected(drawn.error());
    }
    FormatFiles made;
    made.files.push_back(
        {std::format("plan_EPSG{}.dxf", zone.epsg), [text = drawing.text()] { return text; }});
    return made;
}

}  // namespace furrow
