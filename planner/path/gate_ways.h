#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/path/path_builder.h"
#include "planner/settings/settings.h"
#include "planner/turns/rig.h"

#include <optional>

namespace furrow {

extern const Parameter kRouteStart;
extern const Parameter kRouteEnd;
extern const Parameter kRouteRefill;

/// The place where a path begins or ends.
struct RoutePlace {
    Point position;
    std::optional<Gate> gate;
};

/// A point as WKT, the name of a gate, or, if no value is given, the field's first gate. Empty if there is no
/// gate either. Usage: a name that no gate has, a point outside the field.
Result<std::optional<RoutePlace>> routePlace(const Field& field, const Settings& settings,
                                             const Parameter& parameter);

/// The same of a setting with several places, each once, in their order. Empty if none is given.
Result<std::vector<RoutePlace>> routePlaces(const Field& field, const Settings& settings,
                                            const Parameter& parameter);

/// The areas with these gates open, each as a disc of the gate's width.
Result<AllowedAreas> withOpenGates(const AllowedAreas& drivable, const Field& field,
                                   std::span<const std::optional<RoutePlace>> places, const JobContext& job);

/// The short straight on which the machine comes in at a place. At a gate it crosses the boundary, starting
/// as far out as the gate's width allows. Elsewhere it goes towards `next`. Empty if the machine fits in none
/// of the tried headings.
std::optional<Leg> wayIn(const RoutePlace& place, const Field& field, const Rig& rig, Point next);
/// The same out of the field.
std::optional<Leg> wayOut(const RoutePlace& place, const Field& field, const Rig& rig, Point before);

}  // namespace furrow
