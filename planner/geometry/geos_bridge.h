#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <memory>
#include <optional>
#include <string>

namespace furrow {

// The one place that sees GEOS (its re-entrant C API, one context per thread). Every function may be
// called from any thread, answers Cancelled within milliseconds of a stop request, and returns polygons
// in our form: outer rings counter-clockwise, holes clockwise, ordered by area, largest first.

/// How far an arc that stands for a rounded corner may be from its chords.
inline constexpr Length kArcTolerance = metres(0.01);

/// What is at least `distance` inside; corners that point inwards become arcs drawn to `tolerance`. Of more
/// than 20,000 vertices the result may lie up to 10 cm farther inside.
Result<MultiPolygon> eroded(const MultiPolygon& polygons, Length distance, Length tolerance,
                            const JobContext& job);

/// The same with corners kept sharp, but for those that would stick out by more than twice the distance.
Result<MultiPolygon> erodedSharp(const MultiPolygon& polygons, Length distance, const JobContext& job);

/// What is at most `distance` away; corners become arcs drawn to `tolerance`.
Result<MultiPolygon> dilated(const MultiPolygon& polygons, Length distance, Length tolerance,
                             const JobContext& job);

/// What is at most `distance` away from lines, round at their ends; arcs are drawn to `tolerance`.
Result<MultiPolygon> aroundLines(const std::vector<Polyline>& lines, Length distance, Length tolerance, const JobContext& job);

/// A grid that moves nothing by more than measures can tell, for polygons whose edges lie on each other but
/// for rounding, as those of neighbouring lanes do: in floating point whole polygons may get lost then.
inline constexpr Length kSnapGrid = metres(1e-7);

// Coordinates of the results lie on `grid` where it is not 0.
Result<MultiPolygon> difference(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                                Length grid = {});
Result<MultiPolygon> intersection(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                                  Length grid = {});
/// Of polygons that may overlap each other.
Result<MultiPolygon> unionOf(const MultiPolygon& polygons, const JobContext& job, Length grid = {});

/// The pieces into which lines cut polygons; lines that end inside cut nothing off.
Result<MultiPolygon> cutAlong(const MultiPolygon& polygons, const std::vector<Polyline>& lines, const JobContext& job);

/// Across the widest circle that fits inside, to a centimetre or a hundredth of it; 0 of nothing.
Result<Length> breadthOf(const MultiPolygon& polygons, const JobContext& job);

/// Why polygons break the rules of simple features, and where.
struct InvalidPlace {
    std::string reason;  ///< GEOS's words: "Self-intersection", "Ring Self-intersection" ...
    Point place;
};
/// Nothing for valid polygons.
Result<std::optional<InvalidPlace>> findInvalidPlace(const MultiPolygon& polygons, const JobContext& job);

/// Polygons that enclose what these rings enclose, even-odd, without crossings.
Result<MultiPolygon> madeValid(const MultiPolygon& polygons, const JobContext& job);

/// The points of a WKT LINESTRING or POINT. InputRefused: the text is something else.
Result<std::vector<Point>> pointsOfWkt(const std::string& wkt);

/// The lines of a WKT LINESTRING, MULTILINESTRING or a collection of these. InputRefused: the text is something else.
Result<std::vector<Polyline>> linesOfWkt(const std::string& wkt);

struct FarthestPoint {
    Point point;
    Length distance;
};

/// A set of polygons made ready for many questions. May be asked by several threads at once.
class PreparedArea {
public:
    explicit PreparedArea(const MultiPolygon& polygons);
    ~PreparedArea();
    PreparedArea(PreparedArea&&) noexcept;
    PreparedArea& operator=(PreparedArea&&) noexcept;

    /// No point of the lines lies outside; touching the edge is allowed.
    bool covers(const std::vector<Polyline>& lines) const;
    /// Nor does any point of their convex hull: a cheaper test that says no too often.
    bool coversHullOf(const std::vector<Polyline>& lines) const;
    /// Where the lines are farthest outside, among the ends, bends and middles of their parts outside;
    /// nothing where none is.
    std::optional<FarthestPoint> farthestOutside(const std::vector<Polyline>& lines) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace furrow
