#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/turns/turn.h"

#include <span>
#include <vector>

namespace furrow {

/// How the line of a pass comes about.
struct TrackRules {
    Length beside;  ///< of the inset: what the footprint keeps from the edge
    std::span<const Point> driven = {};  ///< corners that are going to be driven into: the line stays as it is there
    /// It is moved as near to the edges as tail and nose let it; otherwise corners keep the arcs of their rounding.
    bool followsEdges = true;
    bool movesIn = true;  ///< where tail or nose would swing out
};

/// The lines of one headland pass: one closed line for the boundary, counter-clockwise, and one for each obstacle, the
/// other way round.
struct PassTracks {
    std::vector<Turn> lines;
    Length movedIn;  ///< at most, because the footprint would have left the field in a bend
    int givenUp = 0;  ///< rings that could not be rounded
    bool inside = false;  ///< seen to be: the footprint stays inside all along
};

/// @param workable  the field less its obstacles
/// @param inset     from the edges of `workable` to the line
/// @param drivable  where the footprint may be
/// Rounded with the machine's radius, or swung out where an implement trails. Where tail or nose would swing out of
/// `drivable` the line moves in by as much and approaches that exponentially, the curve on which the swinging corner
/// follows a straight edge. Cancelled. Cost: one GEOS buffer, a few rounds of looking along the line, and GEOS overlays
/// where corners are too close to each other.
Result<PassTracks> passTracks(const MultiPolygon& workable, Length inset, const MultiPolygon& drivable,
                              const Machine& machine, const TrackRules& rules, const JobContext& job);

/// Where a line with the implement down gets outside, at most one place for each half of the overhang. Not all of
/// them where the job is stopped.
std::vector<Point> placesOutside(const Turn& line, const MultiPolygon& drivable, const Machine& machine,
                                 const JobContext& job);

/// What is left of a line without the places where the footprint is outside with the implement down, and not without
/// stretches shorter than a pass is wide. A closed line is cut open there; it stays as it is where nothing is outside.
std::vector<Turn> partsInside(const Turn& closedLine, const MultiPolygon& drivable, const Machine& machine,
                              const JobContext& job);

}  // namespace furrow
