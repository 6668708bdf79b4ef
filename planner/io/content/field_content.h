#pragma once

#include "planner/field/field.h"
#include "planner/units/quantity.h"

#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// How the points of a guidance line are meant.
enum class GuidanceKind {
    AbLine,  ///< two points, A and B
    APlus,   ///< A and a bearing
    Curve,   ///< two points or more, in order
    Pivot,   ///< the centre, and where an arc is meant its start and end; a radius
};

/// "ab-line", "a-plus", "curve", "pivot": as in plan files.
std::string_view guidanceKindId(GuidanceKind kind);

/// A line that a terminal steers along, as a file holds it or as it is written.
struct GuidanceLine {
    GuidanceKind kind = GuidanceKind::AbLine;
    std::string name;
    GeoRing points;                ///< not closed: a curve that comes back repeats its first point
    std::optional<Angle> bearing;  ///< from north, clockwise; of A+ always, of an AB line where it is stated
    std::optional<Length> radius;  ///< of a pivot
    std::optional<Length> width;   ///< of the implement it was made for
    bool repeats = true;           ///< the terminal lays others beside it; not for a pass driven once
    bool clockwise = false;        ///< way round an arc of a pivot from its start

    friend bool operator==(const GuidanceLine&, const GuidanceLine&) = default;
};

/// Everything about a field that files of machines hold: what is read, and what is written of a plan.
struct FieldContent {
    FieldSource field;
    std::vector<GeoPolygon> mainland;  ///< what is left inside the headland; empty where nothing is known
    std::vector<GuidanceLine> lines;
    std::optional<Area> area;  ///< holes and obstacles taken out, where it was measured

    /// As measured, else of the parts less their holes.
    Area statedArea() const;
};

/// The line as points: itself for AB and curves, `reach` along the bearing for A+, a circle or arc with
/// chords within a centimetre for a pivot.
GeoRing drawn(const GuidanceLine& line, Length reach);

}  // namespace furrow
