#pragma once

#include "planner/core/result.h"
#include "planner/field/allowed_areas.h"
#include "planner/field/field.h"
#include "planner/geometry/curve.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/method.h"
#include "planner/settings/settings.h"
#include "planner/turns/turn_method.h"

#include <functional>
#include <optional>
#include <vector>

namespace furrow {

/// A stretch of a headland pass: worked, or a manoeuvre into a corner with the implement up.
struct PassStretch {
    Curve line;  ///< of the vehicle's reference point
    bool working = true;
    /// Of a short pass: the line of the same work in the other direction, where the machine has room for it.
    std::optional<Curve> otherWay = {};

    friend bool operator==(const PassStretch&, const PassStretch&) = default;
};

/// One ring of the headland, or a part of one.
struct HeadlandPass {
    int ring = 0;  ///< counted from the boundary or obstacle, 0 outermost
    Length width;
    /// Each stretch begins at the end of the one before, and the first at the end of the last. If false,
    /// turns have to join the stretches.
    bool closed = true;
    std::vector<PassStretch> stretches;

    Length length() const;
    friend bool operator==(const HeadlandPass&, const HeadlandPass&) = default;
};

/// The headland along one edge of the field or of an obstacle, the field on its left.
struct EdgeStrip {
    Point from;
    Point to;
    Length width;    ///< from the edge to the mainland
    int passes = 0;  ///< operating widths that fit into it

    friend bool operator==(const EdgeStrip&, const EdgeStrip&) = default;
};

/// The strip kept for turning and the mainland inside it.
struct Headland {
    Length width;                   ///< from the boundary, at most; 0 without a headland
    int passes = 0;                 ///< operating widths that fit into it
    std::vector<EdgeStrip> strips;  ///< of all edges if they differ; empty if all are the same
    MultiPolygon mainland;          ///< the field without headland, in metres
    double mainlandRatio = 0.0;     ///< A_r = area(mainland) / area(field)
    std::vector<HeadlandPass>
        drivenPasses;         ///< in the chosen direction; empty if the strip is only for turning
    Length uncutStrip;        ///< at most, along the boundary outside the outermost pass
    Area uncutCorners;        ///< where that pass is rounded
    std::vector<Note> notes;  ///< what was reduced, and why
    bool narrowed = false;    ///< the field was too narrow for the wanted headland
    /// A single pass all round, inside which no swath is as wide as the implement. The mainland may be empty.
    bool isPerimeterOnly = false;
};

/// The width of the headland along the edge nearest to a place. Cost: O(edges).
Length widthBeside(const Headland& headland, Point place);

/// The width along the edge where it is narrowest. Cost: O(edges).
Length narrowestWidth(const Headland& headland);

/// InputRefused: the margin alone leaves nothing of the field.
Error nothingLeft(Length margin);

/// The poses in which swaths would leave a mainland.
using SwathEnds = std::function<Result<std::vector<Pose>>(const MultiPolygon& mainland)>;

/// The inputs of a headland. The headland keeps none of them.
struct HeadlandTask {
    const Field& field;
    const AllowedAreas& drivable;
    const Machine& machine;
    TurnPlanner* turn;  ///< the kind of turn that will be used
    const Settings& settings;
    Length margin;              ///< distance that everything keeps from the boundary
    Length overhang = {};       ///< how far the implement may stand over every edge
    bool drawsOutEnds = false;  ///< swaths will be extended beyond a slanting edge of the mainland
    SwathEnds swathEnds;        ///< for headlands that depend on them; may fail as the swath method does
    /// Edges to lay the headland along, if different from the field's workable area: without the holes that
    /// swaths go round.
    const MultiPolygon* along = nullptr;

    const MultiPolygon& workable() const { return along != nullptr ? *along : field.workable(); }
};

/// The common signature of all headland methods.
///
/// @return a headland. Its mainland is empty only if a single pass works all of the field. InputRefused:
/// nothing of the field is left. Cancelled.
using HeadlandGenerator = Result<Headland>(const HeadlandTask& task, const JobContext& job);

template <>
struct MethodTraits<HeadlandGenerator> {
    bool isOneWidth = false;  ///< the same all round
};

}  // namespace furrow
