#include "planner/path/gate_ways.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/geometry/segment.h"
#include "planner/geometry/tolerances.h"
#include "planner/geometry/wkt.h"
#include "planner/settings/places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

namespace furrow {

namespace {

constexpr int kDiscCorners = 64;
// Length of the straight drive in or out.
constexpr Length kStraight = metres(2.0);
constexpr double kGateStepM = 0.1;
// Tried headings, to both sides of straight: across the boundary first, then all others if none fits.
constexpr double kAcrossDeg[] = {0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0};
constexpr double kGateAsideDeg[] = {60.0, -60.0, 90.0, -90.0, 135.0, -135.0, 180.0};
// Largest distance inwards from a gate, in lengths of the machine.
constexpr double kLengthsIn = 2.0;

/// The direction from a place on the boundary into the field.
Point inwardFrom(Point place, const Field& field) {
    double nearest = std::numeric_limits<double>::infinity();
    Point inward{1.0, 0.0};
    forEachEdge(field.drivable(), [&](Point a, Point b) {
        const Point way = b - a;
        // Rings have the field on their left.
        if (const double away = distanceToSegment(place, a, b); away < nearest && norm(way) > 0.0) {
            nearest = away;
            inward = (1.0 / norm(way)) * Point{-way.y, way.x};
        }
    });
    return inward;
}

Ring disc(Point centre, double radiusM) {
    Ring ring;
    for (int i = 0; i < kDiscCorners; ++i) {
        ring.push_back(centre + radiusM * direction(2.0 * std::numbers::pi * i / kDiscCorners));
    }
    return ring;
}

/// A straight between the place and the field, driven in or out, as near to the place and as straight as
/// fits.
/// @param other  the next place to drive to, or the one before
std::optional<Leg> straightAt(const RoutePlace& place, const Field& field, const Rig& rig, Point other,
                              bool drivenIn) {
    const Point way = other - place.position;
    const Point inward = place.gate              ? inwardFrom(place.position, field)
                         : norm(way) > kContactM ? (1.0 / norm(way)) * way
                                                 : Point{1.0, 0.0};
    const double mostM = place.gate ? kLengthsIn * rig.machine().spec().tractor.length.si() : 0.0;
    const Point onward = drivenIn ? inward : Point{-inward.x, -inward.y};
    const CurvePiece straight{.length = kStraight, .curvature = {}};
    const auto nearest = [&](std::span<const double> headings) -> std::optional<Leg> {
        for (double m = 0.0; m <= mostM; m += kGateStepM) {
            for (const double aside : headings) {
                const Angle heading = radians(std::atan2(onward.y, onward.x)) + degrees(aside);
                const Point near = place.position + m * inward;
                const Pose start{
                    .position = drivenIn ? near : near - kStraight.si() * direction(heading.si()),
                    .heading = heading};
                if (rig.outsideM(Rig::inLine(start)) <= kContactM &&
                    rig.driven(Rig::inLine(start), straight)) {
                    return Leg{.kind = SegmentKind::Transfer,
                               .number = 0,
                               .line = {.type = {}, .start = start, .pieces = {straight}},
                               .implementDown = false};
                }
            }
        }
        return std::nullopt;
    };
    const auto across = nearest(kAcrossDeg);
    return across ? across : nearest(kGateAsideDeg);
}

Error noSuchPlace(const std::vector<Gate>& gates, const std::string& given, const Parameter& parameter) {
    std::string names;
    for (const Gate& gate : gates) {
        names += (names.empty() ? "" : ", ") + gate.name;
    }
    return {.code = ErrorCode::Usage,
            .what = message("there is no gate '{}'", given),
            .where = std::string{parameter.key},
            .remedy = names.empty() ? Message{"give a point such as POINT (4.1 52.0)"}
                                    : message("give one of {} or a point such as POINT (4.1 52.0)", names)};
}

}  // namespace

Result<std::optional<RoutePlace>> routePlace(const Field& field, const Settings& settings,
                                             const Parameter& parameter) {
    const std::string given = settings.place(parameter);
    const std::vector<Gate>& gates = field.source().gates;
    const auto at = [&](const Gate& gate) { return RoutePlace{field.frame().toLocal(gate.position), gate}; };
    if (given.empty()) {
        return gates.empty() ? std::nullopt : std::optional{at(gates.front())};
    }
    if (const auto gate = std::ranges::find(gates, given, &Gate::name); gate != gates.end()) {
        return at(*gate);
    }
    const auto points = pointsOfWkt(given);
    if (!points || points->size() != 1) {
        return std::unexpected(noSuchPlace(gates, given, parameter));
    }
    const RoutePlace place{field.frame().toLocal({points->front().x, points->front().y}), std::nullopt};
    const PreparedArea inside{field.drivable()};
    if (!inside.covers({{place.position, place.position}})) {
        return std::unexpected(Error{.code = ErrorCode::Usage,
                                     .what = "the place lies outside of the field",
                                     .where = std::string{parameter.key},
                                     .remedy = "give a gate, or a point in the field"});
    }
    return place;
}

Result<std::vector<RoutePlace>> routePlaces(const Field& field, const Settings& settings,
                                            const Parameter& parameter) {
    const std::string given = settings.place(parameter);
    const std::vector<Gate>& gates = field.source().gates;
    std::vector<RoutePlace> places;
    const auto add = [&](Point position, std::optional<Gate> gate) {
        if (std::ranges::none_of(places, [&](const RoutePlace& known) {
                return distance(known.position, position) < kContactM;
            })) {
            places.push_back({position, std::move(gate)});
        }
    };
    const auto gateOf = [&](std::string_view name) { return std::ranges::find(gates, name, &Gate::name); };
    const auto addGate = [&](const Gate& gate) { add(field.frame().toLocal(gate.position), gate); };
    // A name may hold a semicolon.
    if (const auto gate = gateOf(given); !given.empty() && gate != gates.end()) {
        addGate(*gate);
        return places;
    }
    const auto entries = givenPlaces(given);
    if (!entries) {
        return std::unexpected(entries.error());
    }
    const PreparedArea inside{field.drivable()};
    for (const GivenPlace& entry : *entries) {
        if (!entry.point) {
            const auto gate = gateOf(entry.name);
            if (gate == gates.end()) {
                return std::unexpected(noSuchPlace(gates, entry.name, parameter));
            }
            addGate(*gate);
            continue;
        }
        const Point position = field.frame().toLocal(*entry.point);
        if (!inside.covers({{position, position}})) {
            return std::unexpected(Error{.code = ErrorCode::Usage,
                                         .what = message("POINT ({} {}) lies outside of the field",
                                                         entry.point->lonDeg, entry.point->latDeg),
                                         .where = std::string{parameter.key},
                                         .remedy = "give a gate, or a point in the field"});
        }
        add(position, std::nullopt);
    }
    return places;
}

namespace {

Result<MultiPolygon> withOpenGates(const MultiPolygon& drivable, const Field& field,
                                   std::span<const std::optional<RoutePlace>> places, const JobContext& job) {
    MultiPolygon open = drivable;
    for (const auto& place : places) {
        if (place && place->gate && place->gate->width > metres(0.0)) {
            // The margin between the area and the boundary opens with the gate.
            const auto near = intersection(
                field.drivable(),
                {{.outer = disc(place->position, 0.5 * place->gate->width.si()), .holes = {}}}, job);
            if (!near) {
                return near;
            }
            open.insert(open.end(), near->begin(), near->end());
            open.push_back({.outer = disc(place->position, 0.5 * place->gate->width.si()), .holes = {}});
        }
    }
    return open.size() == drivable.size() ? Result<MultiPolygon>{drivable} : unionOf(open, job);
}

}  // namespace

Result<AllowedAreas> withOpenGates(const AllowedAreas& drivable, const Field& field,
                                   std::span<const std::optional<RoutePlace>> places, const JobContext& job) {
    auto tractor = withOpenGates(drivable.tractor(), field, places, job);
    if (!tractor || !drivable.hasOverhang()) {
        return std::move(tractor).transform(
            [](MultiPolygon&& both) { return AllowedAreas{std::move(both)}; });
    }
    return withOpenGates(drivable.implement(), field, places, job).transform([&](MultiPolygon&& implement) {
        return AllowedAreas{*std::move(tractor), std::move(implement)};
    });
}

std::optional<Leg> wayIn(const RoutePlace& place, const Field& field, const Rig& rig, Point next) {
    return straightAt(place, field, rig, next, true);
}

std::optional<Leg> wayOut(const RoutePlace& place, const Field& field, const Rig& rig, Point before) {
    return straightAt(place, field, rig, before, false);
}

const Parameter kRouteStart{.key = "route.start",
                            .name = "Start",
                            .description = "A gate's name or a point; the first gate where nothing is given.",
                            .kind = ParameterKind::Place,
                            .standard = {},
                            .choices = {}};

const Parameter kRouteEnd{.key = "route.end",
                          .name = "End",
                          .description = "A gate's name or a point; the first gate where nothing is given.",
                          .kind = ParameterKind::Place,
                          .standard = {},
                          .choices = {}};

const Parameter kRouteRefill{
    .key = "route.refill",
    .name = "Refill points",
    .description =
        "Where the tank is filled or the bunker emptied: points or names of gates, divided by semicolons.",
    .kind = ParameterKind::Places,
    .standard = {},
    .choices = {}};

}  // namespace furrow
