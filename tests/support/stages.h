#pragma once

#include "planner/field/drivable_area.h"
#include "planner/field/field.h"
#include "planner/headland/headland.h"
#include "planner/machine/machine_library.h"
#include "planner/path/path_builder.h"
#include "planner/path/speed_profile.h"
#include "planner/route/route.h"
#include "planner/settings/method.h"
#include "planner/swaths/scan_line.h"
#include "planner/swaths/swath.h"
#include "planner/turns/dubins.h"

#include <QStringList>

namespace furrow::test {

/// Any field: for methods that only look at the mainland.
inline const Field& anyField() {
    static const Field field =
        Field::create(
            {.parts = {{.outer = {{5.0, 52.0}, {5.01, 52.0}, {5.01, 52.01}, {5.0, 52.01}}, .holes = {}}}})
            .value();
    return field;
}

/// The paper's robot, 2.5 m wide.
inline const Machine& agbot() {
    static const Machine machine = findMachine("agbot").value();
    return machine;
}

/// Straight swaths beside each other, without any method's settings.
inline SwathSet swathsOf(const MultiPolygon& mainland, double widthM, double headingDeg) {
    return ScanLine{mainland, {.width = metres(widthM), .overlap = {}}}.swaths(degrees(headingDeg));
}

inline Result<SwathSet> swathsBy(const Method<SwathGenerator>& method, const MultiPolygon& mainland,
                                 const Machine& machine, const Settings& settings,
                                 const JobContext& job = {}) {
    return method.run({.field = anyField(), .mainland = mainland, .machine = machine, .settings = settings},
                      job);
}

/// With turns that leave swaths which are drawn out, as the defaults have it.
inline Result<Headland> headlandBy(const Method<HeadlandGenerator>& method, const Field& field,
                                   const Machine& machine, const Settings& settings, Length margin = {},
                                   bool drawsOutEnds = true, const JobContext& job = {}) {
    return drivableArea(field, margin, {}).and_then([&](const MultiPolygon& drivable) {
        return method.run({.field = field,
                           .drivable = drivable,
                           .machine = machine,
                           .turn = kDubinsMethod.run,
                           .settings = settings,
                           .margin = margin,
                           .drawsOutEnds = drawsOutEnds},
                          job);
    });
}

inline Result<Route> routeBy(const Method<RoutePlanner>& method, const SwathSet& swaths,
                             const Machine& machine, const Settings& settings, const JobContext& job = {}) {
    return method.run({.swaths = swaths, .machine = machine, .turn = kDubinsMethod.run, .settings = settings},
                      job);
}

/// "0 1- 2": indices in their order, reversed ones with a minus.
inline QString told(const Route& route) {
    QStringList steps;
    for (const RouteStep& step : route.steps) {
        steps << QString::number(step.swath) + (step.reversed ? "-" : "");
    }
    return steps.join(' ');
}

inline Result<Path> pathOf(const SwathSet& swaths, const Route& route, const Machine& machine,
                           TurnPlanner* turn, const JobContext& job = {}) {
    return joinedLegs(swathLegs(swaths, route, machine), machine, waysBy(turn, machine), job)
        .transform(
            [&](const std::vector<Leg>& legs) { return withSpeeds(legs, machine, SteeringLimit::Ignored); });
}

}  // namespace furrow::test
