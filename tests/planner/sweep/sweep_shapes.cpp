#include "tests/planner/sweep/sweep_shapes.h"

#include "planner/io/import/boundary_import.h"
#include "tests/support/field_generator.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <numbers>
#include <span>
#include <vector>

namespace furrow::test {

namespace {

constexpr GeoPoint kCentre{9.5, 51.5};

Ring ellipse(Point middle, double halfWidthM, double halfHeightM, int corners, bool clockwise) {
    Ring ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = (clockwise ? -2.0 : 2.0) * std::numbers::pi * i / corners;
        ring.push_back(middle + Point{halfWidthM * std::cos(angle), halfHeightM * std::sin(angle)});
    }
    return ring;
}

Polygon withPond(Polygon polygon, Point middle, double halfWidthM, double halfHeightM) {
    polygon.holes.push_back(ellipse(middle, halfWidthM, halfHeightM, 12, true));
    return polygon;
}

/// Four teeth, 45 m broad and 110 m long, on a back 70 m broad.
Polygon comb() {
    Ring ring{{0.0, 0.0}, {330.0, 0.0}};
    for (int tooth = 3; tooth >= 0; --tooth) {
        const double left = 95.0 * tooth;
        ring.insert(ring.end(), {{left + 45.0, 180.0}, {left, 180.0}});
        if (tooth > 0) {
            ring.insert(ring.end(), {{left, 70.0}, {left - 50.0, 70.0}});
        }
    }
    return {.outer = std::move(ring), .holes = {}};
}

/// One side juts back and forth by 5 m, as where it was traced along a wood.
Polygon slalom() {
    Ring ring{{0.0, 0.0}, {300.0, 0.0}};
    for (int i = 0; i <= 20; ++i) {
        ring.push_back({300.0 - 15.0 * i, i % 2 == 0 ? 200.0 : 205.0});
    }
    return {.outer = std::move(ring), .holes = {}};
}

Polygon lShape(double sizeM) {
    const double half = 0.45 * sizeM;
    return {.outer = {{0.0, 0.0}, {sizeM, 0.0}, {sizeM, half}, {half, half}, {half, sizeM}, {0.0, sizeM}},
            .holes = {}};
}

FieldSource fromLocal(const MultiPolygon& polygons) {
    return fieldSourceFromLocal(polygons, kCentre);
}

Polygon parallelogram() {
    return {.outer = {{0.0, 0.0}, {320.0, 0.0}, {390.0, 190.0}, {70.0, 190.0}}, .holes = {}};
}

FieldSource wetSpot() {
    FieldSource source = fromLocal({rectangle(300.0, 200.0)});
    const MultiPolygon spot{{.outer = ellipse({140.0, 110.0}, 20.0, 12.0, 12, false), .holes = {}}};
    source.obstacles.push_back(
        {.name = "Wet spot", .outline = fromLocal(spot).parts.front(), .passable = true, .buffer = {}});
    return source;
}

/// Its gate is at the foot of the short arm.
FieldSource gatedL() {
    FieldSource source = fromLocal({lShape(280.0)});
    const Ring mark{{280.0, 60.0}, {281.0, 60.0}, {281.0, 61.0}};
    source.gates.push_back({.name = "Lane",
                            .position = fromLocal({{.outer = mark, .holes = {}}}).parts[0].outer[0],
                            .width = metres(9.0)});
    return source;
}

FieldSource shipped(const char* file) {
    return readBoundaries(std::string{FURROW_SOURCE_DIR "/resources/sample_fields/"} + file + ".geojson")
        .value()
        .front();
}

/// A name and the field of that name, for a machine so broad.
struct NamedField {
    std::string_view name;
    FieldSource (*made)(double widthM);
};

constexpr Angle kTurned = degrees(27.0);

constexpr NamedField kFields[] = {
    {"rectangle", [](double) { return fromLocal({rectangle(400.0, 250.0)}); }},
    {"slanted", [](double) { return fromLocal(moved({parallelogram()}, kTurned, {})); }},
    {"l-shape", [](double) { return gatedL(); }},
    {"comb", [](double) { return fromLocal({comb()}); }},
    {"triangle",
     [](double) { return fromLocal({{.outer = {{0.0, 0.0}, {360.0, 0.0}, {130.0, 280.0}}, .holes = {}}}); }},
    {"circle",
     [](double) { return fromLocal({{.outer = ellipse({}, 130.0, 130.0, 72, false), .holes = {}}}); }},
    {"strip", [](double widthM) { return fromLocal(moved({rectangle(350.0, 3.0 * widthM)}, kTurned, {})); }},
    {"pond",
     [](double) { return fromLocal({withPond(rectangle(340.0, 240.0), {180.0, 130.0}, 30.0, 22.0)}); }},
    {"headland-pond",
     [](double) { return fromLocal({withPond(rectangle(320.0, 220.0), {140.0, 20.0}, 11.0, 8.0)}); }},
    {"wet-spot", [](double) { return wetSpot(); }},
    {"two-parts",
     [](double) { return fromLocal({rectangle(180.0, 130.0), rectangle(110.0, 190.0, {215.0, 10.0})}); }},
    {"slalom", [](double) { return fromLocal({slalom()}); }},
    {"five-ha", [](double) { return shipped("home_field"); }},
    {"fifty-ha", [](double) { return shipped("great_field"); }},
};
constexpr NamedField kSmallFields[] = {
    {"small-rectangle", [](double) { return fromLocal({rectangle(100.0, 62.0)}); }},
    {"small-pond",
     [](double) { return fromLocal({withPond(rectangle(110.0, 80.0), {50.0, 42.0}, 8.0, 6.0)}); }},
    {"small-l", [](double) { return fromLocal({lShape(100.0)}); }},
};

std::vector<std::string> namesOf(std::span<const NamedField> fields) {
    std::vector<std::string> names;
    for (const NamedField& field : fields) {
        names.emplace_back(field.name);
    }
    return names;
}

std::string degreesText(double value) {
    return std::format("{:.10f}", value);
}

GeoPoint asWritten(GeoPoint point) {
    return {std::stod(degreesText(point.lonDeg)), std::stod(degreesText(point.latDeg))};
}

GeoPolygon asWritten(GeoPolygon polygon) {
    std::ranges::transform(polygon.outer, polygon.outer.begin(),
                           [](GeoPoint point) { return asWritten(point); });
    for (GeoRing& hole : polygon.holes) {
        std::ranges::transform(hole, hole.begin(), [](GeoPoint point) { return asWritten(point); });
    }
    return polygon;
}

/// With the coordinates that a file of it has, so that furrow-cli plans the very same field.
FieldSource asWritten(FieldSource source) {
    for (GeoPolygon& part : source.parts) {
        part = asWritten(std::move(part));
    }
    for (Obstacle& obstacle : source.obstacles) {
        obstacle.outline = asWritten(std::move(obstacle.outline));
    }
    for (Gate& gate : source.gates) {
        gate.position = asWritten(gate.position);
    }
    return source;
}

std::string ringText(const GeoRing& ring) {
    std::string text = "[";
    for (std::size_t i = 0; i <= ring.size(); ++i) {
        const GeoPoint& point = ring[i % ring.size()];
        text += std::format("{}[{:.10f},{:.10f}]", i == 0 ? "" : ",", point.lonDeg, point.latDeg);
    }
    return text + "]";
}

std::string polygonText(const GeoPolygon& polygon) {
    std::string text = "[" + ringText(polygon.outer);
    for (const GeoRing& hole : polygon.holes) {
        text += "," + ringText(hole);
    }
    return text + "]";
}

}  // namespace

std::vector<std::string> sweepShapes() {
    return namesOf(kFields);
}

std::vector<std::string> smallSweepShapes() {
    return namesOf(kSmallFields);
}

FieldSource sweepField(std::string_view shape, const Machine& machine) {
    for (const std::span<const NamedField> fields :
         {std::span<const NamedField>{kFields}, std::span<const NamedField>{kSmallFields}}) {
        if (const auto found = std::ranges::find(fields, shape, &NamedField::name); found != fields.end()) {
            return asWritten(found->made(machine.operatingWidth().si()));
        }
    }
    return {};
}

std::string geoJsonOf(const FieldSource& source) {
    const auto feature = [](std::string_view kind, std::string_view more, std::string_view type,
                            std::string_view coordinates) {
        return std::format(
            R"({{"type":"Feature","properties":{{"kind":"{}"{}}},"geometry":{{"type":"{}","coordinates":{}}}}})",
            kind, more, type, coordinates);
    };
    std::string parts;
    for (const GeoPolygon& part : source.parts) {
        parts += (parts.empty() ? "" : ",") + polygonText(part);
    }
    std::string text = R"({"type":"FeatureCollection","features":[)";
    text += feature("field", std::format(R"(,"name":"{}")", source.name), "MultiPolygon", "[" + parts + "]");
    for (const Obstacle& obstacle : source.obstacles) {
        text += ",\n" + feature("obstacle",
                                std::format(R"(,"name":"{}","passable":{},"buffer_m":{})", obstacle.name,
                                            obstacle.passable, obstacle.buffer.si()),
                                "Polygon", polygonText(obstacle.outline));
    }
    for (const Gate& gate : source.gates) {
        text +=
            ",\n" + feature("gate", std::format(R"(,"name":"{}","width_m":{})", gate.name, gate.width.si()),
                            "Point",
                            std::format("[{:.10f},{:.10f}]", gate.position.lonDeg, gate.position.latDeg));
    }
    return text + "]}\n";
}

}  // namespace furrow::test
