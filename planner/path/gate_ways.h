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

/// Where a path begins or ends.
struct RoutePlace {
    Point position;
    std::optional<Gate> gate;
};

/// A point as WKT, the name of a gate, or, where nothing is given, the field's first gate. Nothing where there is
/// none either. Usage: a name that no gate has, a point outside of the field.
Result<std::optional<RoutePlace>> routePlace(const Field& field, const Settings& settings, const Parameter& parameter);

/// The drivable area with these gates open: discs as wide as they are.
Result<MultiPolygon> withOpenGates(const MultiPolygon& drivable, const Field& field,
                                   std::span<const std::optional<RoutePlace>> places, const JobContext& job);

/// The short straight on which the machine comes in at a place: at a gate across the boundary, as far out as the gate
/// is wide enough for; elsewhere towards `next`. Nothing where the machine fits in no heading that was tried.
std::optional<Leg> wayIn(const RoutePlace& place, const Field& field, const Rig& rig, Point next);
/// The same out of the field.
std::optional<Leg> wayOut(const RoutePlace& place, const Field& field, const Rig& rig, Point before);

}  // namespace furrow
