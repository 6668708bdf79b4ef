#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <memory>
#include <optional>
#include <string>

namespace furrow {

// Only this module uses GEOS (its re-entrant C API, one context per thread). Every function may be called
// from any thread. It returns Cancelled within milliseconds of a stop request. It returns polygons in our
// form: outer rings counter-clockwise, holes clockwise, ordered by area, largest first.

/// Largest distance between the arc of a rounded corner and its chords.
inline constexpr Length kArcTolerance = metres(0.01);

/// The area at least `distance` inside. Corners that point inwards become arcs drawn to `tolerance`. Of a
/// polygon of over 2,000 sharp corners it may lie 5 cm farther inside, of over 20,000 vertices 10 cm.
Result<MultiPolygon> eroded(const MultiPolygon& polygons, Length distance, Length tolerance,
                            const JobContext& job);

/// The same with sharp corners, except those that would stick out by more than twice the distance.
Result<MultiPolygon> erodedSharp(const MultiPolygon& polygons, Length distance, const JobContext& job);

/// The area at most `distance` away. Corners become arcs drawn to `tolerance`.
Result<MultiPolygon> dilated(const MultiPolygon& polygons, Length distance, Length tolerance,
                             const JobContext& job);

/// The area at most `distance` away from lines, round at their ends. Arcs are drawn to `tolerance`.
Result<MultiPolygon> aroundLines(const std::vector<Polyline>& lines, Length distance, Length tolerance,
                                 const JobContext& job);

/// A grid for polygons whose edges lie on each other except for rounding, like those of neighbouring lanes.
/// In floating point, whole polygons may get lost there. The grid moves points by less than any measurement
/// can tell.
inline constexpr Length kSnapGrid = metres(1e-7);

// Coordinates of the results lie on `grid`, unless it is 0.
Result<MultiPolygon> difference(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                                Length grid = {});
Result<MultiPolygon> intersection(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                                  Length grid = {});
/// The polygons may overlap each other.
Result<MultiPolygon> unionOf(const MultiPolygon& polygons, const JobContext& job, Length grid = {});

/// The pieces into which lines cut polygons. A line that ends inside cuts nothing off.
Result<MultiPolygon> cutAlong(const MultiPolygon& polygons, const std::vector<Polyline>& lines,
                              const JobContext& job);

/// The diameter of the widest circle inside, to a centimetre or a hundredth of it; 0 for no polygons.
Result<Length> breadthOf(const MultiPolygon& polygons, const JobContext& job);

/// The reason why polygons break the rules of simple features, and the place.
struct InvalidPlace {
    std::string reason;  ///< GEOS's words: "Self-intersection", "Ring Self-intersection" ...
    Point place;
};
/// Empty for valid polygons.
Result<std::optional<InvalidPlace>> findInvalidPlace(const MultiPolygon& polygons, const JobContext& job);

/// Polygons with the same enclosed area as these rings, even-odd, without crossings.
Result<MultiPolygon> madeValid(const MultiPolygon& polygons, const JobContext& job);

}  // namespace furrow
