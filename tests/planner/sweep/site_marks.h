#pragma once

#include "tests/planner/sweep/sweep_values.h"

namespace furrow::test {

// Places, lines and files made for one field, in its local frame and in metres.

/// How far a place is from all edges; negative outside.
double insideM(const MultiPolygon& area, Point place);

/// The place that is farthest from every edge, of those on a grid.
Point middleOf(const SweepSite& site);

/// Parallel to the longest edge of the outlines, so many operating widths inside of it.
Polyline besideLongestEdge(const SweepSite& site, double widthsIn);

/// A line through the middle, turned by so much from the longest edge, so far to both sides.
Polyline throughMiddle(const SweepSite& site, double turnedDeg, double reachM);

/// Beside the longest edge, with a gentle bend into the field.
Polyline bendAlongEdge(const SweepSite& site);

/// As WKT.
std::string lineText(const SweepSite& site, const Polyline& line);
std::string pointText(const SweepSite& site, Point point);

/// Writes rows along the longest edge, so many operating widths apart; gives the file's path.
std::string rowFile(const SweepSite& site, double widthsApart);

/// Writes heights around the field: a slope with a bend, or a hill in its middle; gives the file's path.
std::string heightFile(const SweepSite& site, bool hill);

}  // namespace furrow::test
