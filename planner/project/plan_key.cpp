#include "planner/project/plan_key.h"

#include "planner/core/fingerprint.h"
#include "planner/machine/machine_file.h"
#include "planner/plan/method_registry.h"

#include <filesystem>
#include <format>

namespace furrow {

namespace {

void add(std::string& text, const GeoRing& ring) {
    for (const GeoPoint& point : ring) {
        text += std::format("{} {},", point.lonDeg, point.latDeg);
    }
    text += ';';
}

void add(std::string& text, const GeoPolygon& polygon) {
    add(text, polygon.outer);
    for (const GeoRing& hole : polygon.holes) {
        add(text, hole);
    }
    text += '|';
}

}  // namespace

std::string fieldInputs(const FieldSource& field) {
    std::string text = std::format("{}\n{}\n{}\n", field.id, field.name, field.boundaryAccuracy.si());
    for (const GeoPolygon& part : field.parts) {
        add(text, part);
    }
    for (const Obstacle& obstacle : field.obstacles) {
        text += std::format("\nobstacle {} {} {} ", obstacle.name, obstacle.passable, obstacle.buffer.si());
        // Fields without overhangs keep the keys that they have in older batches.
        if (obstacle.overhang != Length{}) {
            text += std::format("{}{} ", "overhang ", obstacle.overhang.si());
        }
        add(text, obstacle.outline);
    }
    for (const Gate& gate : field.gates) {
        text += std::format("\ngate {} {} {} {}", gate.name, gate.position.lonDeg, gate.position.latDeg,
                            gate.width.si());
    }
    for (const EdgeWidth& edge : field.edgeHeadlands) {
        text += std::format("\nedge {} {} {} {}", edge.part, edge.ring, edge.edge, edge.width.si());
    }
    for (const EdgeWidth& edge : field.edgeOverhangs) {
        text += std::format("\nover {} {} {} {}", edge.part, edge.ring, edge.edge, edge.width.si());
    }
    return text;
}

/// For files in settings, their size and age.
std::string settingInputs(const Settings& settings) {
    std::string text;
    for (const Parameter* parameter : allParameters()) {
        if (!settings.isSet(*parameter)) {
            continue;
        }
        text += std::format("{}={}\n", parameter->key, settingText(settings.value(*parameter)));
        if (parameter->kind == ParameterKind::File) {
            std::error_code ignored;
            const std::filesystem::path file = settings.file(*parameter);
            text += std::format("{} {}\n", std::filesystem::file_size(file, ignored),
                                std::filesystem::last_write_time(file, ignored).time_since_epoch().count());
        }
    }
    return text;
}

std::string planInputs(const FieldSource& field, const Machine& machine, const Settings& settings) {
    return fieldInputs(field) + machineJson(machine.spec()) + settingInputs(settings);
}

std::string planKey(const FieldSource& field, const FieldPlan& plan) {
    return fingerprint(planInputs(field, plan.machine, plan.settings)).substr(0, 16);
}

}  // namespace furrow
