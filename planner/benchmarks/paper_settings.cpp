#include "planner/benchmarks/paper_settings.h"

#include "planner/field/field.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"

#include <cmath>
#include <numbers>

namespace furrow {

namespace {

constexpr Area kShapeArea = squareMetres(100.0);

constexpr std::pair<std::string_view, std::string_view> kSetUp[] = {
    {"field.margin_m", "0"},           {"headland.method", "constant"}, {"headland.width_m", "7.5"},
    {"swaths.method", "brute-force"},  {"swaths.step_deg", "1"},        {"swaths.last_pass", "gap"},
    {"route.method", "boustrophedon"}, {"route.corner", "first"},       {"path.method", "dubins"},
    {"path.stay_inside", "false"},
};

// A planner without these settings already does what they set.
constexpr std::pair<std::string_view, std::string_view> kWhereThereIs[] = {
    {"decomposition.method", "none"},    {"swaths.ends", "centre"},    {"swaths.min_length_m", "0"},
    {"swaths.prefer_edge_percent", "0"}, {"headland.driven", "false"},
};

}  // namespace

Machine paperMachine() {
    // In the paper the robot is a point: its implement works at its reference point.
    const Machine& robot = machineLibrary().front();
    MachineSpec spec = robot.spec();
    spec.implement.offset = metres(0.0);
    return Machine::create(spec).value_or(robot);
}

Result<Settings> paperSettings(std::initializer_list<std::pair<std::string_view, std::string_view>> own) {
    Settings settings;
    Result<void> applied;
    const auto apply = [&](std::string_view key, std::string_view value) {
        if (applied) {
            applied = applySetting(settings, key, value);
        }
    };
    for (const auto& [key, value] : kSetUp) {
        apply(key, value);
    }
    for (const auto& [key, value] : kWhereThereIs) {
        if (findParameter(key)) {
            apply(key, value);
        }
    }
    for (const auto& [key, value] : own) {
        apply(key, value);
    }
    if (!applied) {
        return std::unexpected(applied.error());
    }
    return settings;
}

Polygon scaledTo(const Polygon& outline, Area wanted) {
    const Bounds box = bounds(outline);
    const Point middle = 0.5 * (box.min + box.max);
    const double factor = std::sqrt(wanted / area(outline));
    Polygon scaled;
    for (const Point& point : outline.outer) {
        scaled.outer.push_back(factor * (point - middle));
    }
    return scaled;
}

Result<std::shared_ptr<const Field>> fieldOf(const Polygon& outline, const std::string& name) {
    const auto frame = LocalFrame::centredOn({.lonDeg = 5.66, .latDeg = 51.98});
    if (!frame) {
        return std::unexpected(frame.error());
    }
    auto field = Field::create({.id = name, .name = name, .origin = name, .parts = {frame->toGeo(outline)}});
    if (!field) {
        return std::unexpected(field.error());
    }
    return std::make_shared<const Field>(std::move(*field));
}

Polygon paperRectangle() {
    return scaledTo({.outer = {{0.0, 0.0}, {16.0, 0.0}, {16.0, 9.0}, {0.0, 9.0}}, .holes = {}}, kShapeArea);
}

Polygon paperCircle() {
    // Long enough that swaths of 2.5 m need two lengthwise and eight across.
    constexpr int kCorners = 20;
    constexpr double kElongation = 3.85;
    Polygon shape;
    for (int i = 0; i < kCorners; ++i) {
        const Point at = direction(2.0 * std::numbers::pi * i / kCorners);
        shape.outer.push_back({kElongation * at.x, at.y});
    }
    return scaledTo(shape, kShapeArea);
}

Polygon paperSlanted() {
    return scaledTo({.outer = {{0.0, 0.0}, {17.85, 0.0}, {21.35, 5.6}, {3.5, 5.6}}, .holes = {}}, kShapeArea);
}

}  // namespace furrow
