#pragma once

#include "planner/io/content/field_content.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/plan.h"
#include "tests/support/geo_rings.h"
#include "tests/support/scratch.h"

#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

#include <cmath>
#include <memory>
#include <string>

// Fields that every format is tried with, and what the tests of formats share.

namespace furrow::test {

inline GeoRing box(double lonDeg, double latDeg, double widthDeg, double heightDeg) {
    return {{lonDeg, latDeg},
            {lonDeg + widthDeg, latDeg},
            {lonDeg + widthDeg, latDeg + heightDeg},
            {lonDeg, latDeg + heightDeg}};
}

inline FieldContent plainField() {
    return {.field = {.id = "north",
                      .name = "North Field",
                      .parts = {{.outer = box(9.0, 52.0, 0.003, 0.002), .holes = {}}}}};
}

/// Holes, two parts, obstacles of both kinds, a gate, a headland, lines of every kind; a name with umlauts
/// and '&'.
inline FieldContent fieldWithEverything() {
    FieldContent content = plainField();
    FieldSource& field = content.field;
    field.id = "7";
    field.name = "Höhe & Senke";
    field.parts[0].holes = {{{9.001, 52.0005}, {9.001, 52.0008}, {9.0013, 52.0008}, {9.0013, 52.0005}}};
    field.parts.push_back({.outer = box(9.004, 52.0, 0.002, 0.002), .holes = {}});
    field.obstacles = {
        {.name = "Pylon", .outline = {.outer = box(9.002, 52.001, 0.0001, 0.0001), .holes = {}}},
        {.name = "Wet spot",
         .outline = {.outer = box(9.005, 52.001, 0.0001, 0.0001), .holes = {}},
         .passable = true}};
    field.gates = {{.name = "Lane", .position = {9.0, 52.001}, .width = metres(6.0)}};
    content.mainland = {
        {.outer = box(9.0002, 52.0001, 0.0026, 0.0018),
         .holes = {{{9.0009, 52.0004}, {9.0009, 52.0009}, {9.0014, 52.0009}, {9.0014, 52.0004}}}}};
    content.lines = {
        {.kind = GuidanceKind::AbLine,
         .name = "AB",
         .points = {{9.0003, 52.0003}, {9.0027, 52.0003}},
         .width = metres(6.0)},
        {.kind = GuidanceKind::Curve,
         .name = "Bend",
         .points = {{9.0003, 52.0012}, {9.001, 52.0013}, {9.002, 52.0012}, {9.0027, 52.0010}}},
        {.kind = GuidanceKind::APlus, .name = "A+", .points = {{9.0005, 52.0005}}, .bearing = degrees(30.0)},
        {.kind = GuidanceKind::Pivot, .name = "Pivot", .points = {{9.0015, 52.001}}, .radius = metres(60.0)}};
    return content;
}

inline FieldContent onTheAntimeridian() {
    return {.field = {
                .id = "t",
                .name = "Taveuni",
                .parts = {
                    {.outer = {{179.999, -16.8}, {-179.999, -16.8}, {-179.999, -16.798}, {179.999, -16.798}},
                     .holes = {}}}}};
}

inline FieldContent onTheGreenwichMeridianInTheSouth() {
    return {.field = {.id = "g",
                      .name = "Gulf",
                      .parts = {{.outer = box(-0.001, -0.001, 0.002, 0.002), .holes = {}}}}};
}

/// A hundred square holes in rows of ten.
inline FieldContent hundredHoles() {
    FieldContent content{.field = {.id = "h",
                                   .name = "Sieve",
                                   .parts = {{.outer = box(9.0, 52.0, 0.011, 0.011), .holes = {}}}}};
    for (int i = 0; i < 100; ++i) {
        GeoRing hole = box(9.0005 + 0.001 * (i % 10), 52.0005 + 0.001 * (i / 10), 0.0003, 0.0003);
        std::reverse(hole.begin(), hole.end());
        content.field.parts[0].holes.push_back(hole);
    }
    return content;
}

/// A wavy disc of 50,000 corners, about 20 cm apart.
inline FieldContent manyCorners() {
    FieldContent content{.field = {.id = "m", .name = "Disc", .parts = {{}}}};
    constexpr int kCorners = 50'000;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2.0 * M_PI * i / kCorners;
        const double radius = 0.014 * (1.0 + 0.05 * std::sin(40.0 * angle));
        content.field.parts[0].outer.push_back(
            {5.0 + radius * std::cos(angle), 45.0 + 0.7 * radius * std::sin(angle)});
    }
    return content;
}

struct FormatCase {
    const char* name;
    FieldContent (*field)();
};
inline constexpr FormatCase kFormatCases[] = {
    {"plain field", plainField},
    {"everything", fieldWithEverything},
    {"across the antimeridian", onTheAntimeridian},
    {"0 degrees, southern and western", onTheGreenwichMeridianInTheSouth},
    {"100 holes", hundredHoles},
    {"50,000 points", manyCorners}};

/// The plan of a field with the first machine, or of another one; null where it is refused, with a warning.
inline std::shared_ptr<const Plan> planOf(const FieldSource& source, std::string_view machine = "agbot",
                                          const Settings& settings = {}) {
    const auto field = Field::create(source);
    if (!field) {
        qWarning("%s", field.error().line().c_str());
        return nullptr;
    }
    const auto plan =
        makePlan({std::make_shared<const Field>(*field), findMachine(machine).value(), settings});
    if (!plan) {
        qWarning("%s", plan.error().line().c_str());
        return nullptr;
    }
    return *plan;
}

/// A plan with a hole, an obstacle and a gate, which reverses. Made once.
inline const Plan& planWithEverything() {
    static const std::shared_ptr<const Plan> made = [] {
        FieldSource source = fieldWithEverything().field;
        source.parts.resize(1);
        source.obstacles.resize(1);
        return planOf(source, "power-harrow-drill");
    }();
    return *made;
}

/// What a program printed; its status is -1 where it is not there.
struct Printed {
    int status = -1;
    QByteArray out;
    QByteArray error;
};

inline Printed run(const QString& program, const QStringList& arguments) {
    if (QStandardPaths::findExecutable(program).isEmpty()) {
        return {};
    }
    QProcess process;
    process.start(program, arguments);
    if (!process.waitForFinished(120'000)) {
        return {-2, {}, "it did not end"};
    }
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

/// A script of tests/validators with the npm packages beside it.
inline Printed runNode(const QString& script, const QStringList& arguments) {
    const QString modules = qEnvironmentVariable("FURROW_NODE_MODULES");
    if (modules.isEmpty() || !QFileInfo::exists(modules)) {
        return {};
    }
    return run("node",
               QStringList{QStringLiteral(FURROW_SOURCE_DIR "/tests/validators/") + script} + arguments);
}

}  // namespace furrow::test
