#pragma once

#include "planner/core/result.h"
#include "planner/field/allowed_areas.h"
#include "planner/geometry/curve.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"

#include <span>
#include <vector>

namespace furrow {

/// Rules for the line of a pass.
struct TrackRules {
    Length beside;                       ///< part of the inset: distance of the footprint from the edge
    std::span<const Point> driven = {};  ///< corners to be driven into: the line stays unchanged there
    /// The line moves as near to the edges as tail and nose allow. If false, corners keep the arcs of their
    /// rounding.
    bool followsEdges = true;
    bool movesIn = true;  ///< at places where tail or nose would swing out
    /// The curvature changes no faster than the steering follows, but for the driven corners. If false, it
    /// jumps between straights and arcs, so that corners can be told from them.
    bool isSteered = false;
};

/// The lines of one headland pass: one closed line for the boundary, counter-clockwise, and one for each
/// obstacle, clockwise.
struct PassTracks {
    std::vector<Curve> lines;
    Length movedIn;       ///< at most, because the footprint would have left the field in a bend
    int givenUp = 0;      ///< rings that could not be rounded
    bool inside = false;  ///< checked: the footprint stays inside everywhere
};

/// @param workable  the field less its obstacles
/// @param inset     from the edges of `workable` to the line
/// Lines are rounded with the machine's radius, or swung out for a trailed implement. Where tail or nose
/// would leave `drivable`, the line moves in by the excess. The move decays exponentially before and after:
/// on this curve the swinging corner follows a straight edge. Cancelled. Cost: one GEOS buffer, a few checks
/// along the line, and GEOS overlays where corners are too close to each other.
Result<PassTracks> passTracks(const MultiPolygon& workable, Length inset, const AllowedAreas& drivable,
                              const Machine& machine, const TrackRules& rules, const JobContext& job);

/// Places where a line with the implement down is outside, at most one for each half of the overhang.
/// Incomplete if the job is stopped.
std::vector<Point> placesOutside(const Curve& line, const AllowedAreas& drivable, const Machine& machine,
                                 const JobContext& job);

/// The parts of a line on which the footprint, implement down, is inside. Parts shorter than the width of a
/// pass are dropped. A closed line is cut open there. It stays unchanged if nothing is outside.
std::vector<Curve> partsInside(const Curve& closedLine, const AllowedAreas& drivable, const Machine& machine,
                               const JobContext& job);

}  // namespace furrow
