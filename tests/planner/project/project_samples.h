#pragma once

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project.h"

#include <QtLogging>

namespace furrow::test {

/// A field with two parts, a hole, an obstacle and a gate; ends of numbers that need all their digits.
inline FieldSource sampleSource() {
    return {
        .id = "12",
        .name = "Große Wiese",
        .origin = "fields.gpkg, feature 12",
        .parts = {GeoPolygon{
                      .outer = {{22.5, 58.25}, {22.507, 58.25}, {22.507, 58.2535}, {22.5 + 1e-13, 58.2535}},
                      .holes = {{{22.502, 58.251}, {22.503, 58.252}, {22.503, 58.251}}}},
                  GeoPolygon{.outer = {{22.51, 58.25}, {22.513, 58.25}, {22.513, 58.252}}, .holes = {}}},
        .obstacles = {{.name = "Pond",
                       .outline = {.outer = {{22.504, 58.2515}, {22.505, 58.2515}, {22.505, 58.252}},
                                   .holes = {}},
                       .passable = true,
                       .buffer = metres(2.5),
                       .overhang = metres(3.5)}},
        .gates = {{.name = "Road", .position = {22.5, 58.251}, .width = metres(6.0)}},
        .edgeHeadlands = {{.part = 0, .ring = 0, .edge = 1, .width = metres(18.0)}},
        .edgeOverhangs = {{.part = 0, .ring = 1, .edge = 2, .width = metres(4.5)}},
        .boundaryAccuracy = metres(0.02),
        .repairs = {}};
}

inline Settings sampleSettings() {
    Settings settings;
    for (const auto& [key, text] : {std::pair{"headland.width_m", "24.5"},
                                    {"swaths.method", "ab-line"},
                                    {"swaths.line", "LINESTRING (22.5 58.25, 22.507 58.2535)"},
                                    {"headland.driven", "false"}}) {
        if (!applySetting(settings, key, text)) {
            qFatal("%s is no setting", key);
        }
    }
    return settings;
}

inline Project sampleProject() {
    Project project = Project::empty();
    project.name = "Kuressaare farm";
    ProjectField field{.id = "field-1",
                       .source = std::make_shared<const FieldSource>(sampleSource()),
                       .plans = {},
                       .others = {},
                       .obstacleOthers = {},
                       .gateOthers = {}};
    for (std::size_t i = 0; i < 2; ++i) {
        field.plans.push_back({.id = "plan-" + std::to_string(i + 1),
                               .name = i == 0 ? "Spring drilling" : "Harvest",
                               .season = "2026",
                               .machine = machineLibrary()[i],
                               .settings = i == 0 ? sampleSettings() : Settings{},
                               .others = {}});
    }
    project.fields = {std::make_shared<const ProjectField>(field)};
    field.id = "field-2";
    field.plans.erase(field.plans.begin() + 1, field.plans.end());
    field.plans.front().id = "plan-3";
    project.fields.push_back(std::make_shared<const ProjectField>(field));
    project.currentField = 1;
    return project;
}

}  // namespace furrow::test
