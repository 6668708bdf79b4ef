#pragma once

#include "planner/field/drivable_area.h"
#include "planner/field/field.h"
#include "planner/headland/headland.h"
#include "planner/path/path_builder.h"
#include "planner/route/route.h"
#include "planner/settings/method.h"
#include "planner/swaths/swath.h"
#include "planner/turns/dubins.h"

namespace furrow::test {

/// Any field: for methods that only look at the mainland.
inline const Field& anyField() {
    static const Field field =
        Field::create({.parts = {{.outer = {{5.0, 52.0}, {5.01, 52.0}, {5.01, 52.01}, {5.0, 52.01}}, .holes = {}}}})
            .value();
    return field;
}

inline Result<SwathSet> swathsBy(const Method<SwathGenerator>& method, const MultiPolygon& mainland,
                                 const Machine& machine, const Settings& settings, const JobContext& job = {}) {
    return method.run({.field = anyField(), .mainland = mainland, .machine = machine, .settings = settings}, job);
}

/// With turns that leave swaths which are drawn out, as the defaults have it.
inline Result<Headland> headlandBy(const Method<HeadlandGenerator>& method, const Field& field, const Machine& machine,
                                   const Settings& settings, Length margin = {}, bool drawsOutEnds = true,
                                   const JobContext& job = {}) {
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

inline Result<Route> routeBy(const Method<RoutePlanner>& method, const SwathSet& swaths, const Machine& machine,
                             const Settings& settings, const JobContext& job = {}) {
    return method.run(
        {.swaths = swaths, .machine = machine, .turn = kDubinsMethod.run, .settings = settings}, job);
}

inline Result<Path> pathOf(const SwathSet& swaths, const Route& route, const Machine& machine, TurnPlanner* turn,
                           const JobContext& job = {}) {
    return buildPath(swathLegs(swaths, route, machine), machine, waysBy(turn, machine), job);
}

}  // namespace furrow::test
