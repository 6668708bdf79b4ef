#pragma once

#include "planner/core/geo_point.h"

#include <span>

namespace furrow {

/// A finite longitude and latitude in their ranges.
bool isOnEarth(GeoPoint point);

/// Which way round a ring runs, seen from above; right across the antimeridian too.
bool isCounterClockwise(std::span<const GeoPoint> ring);

/// Longitude that differs from the anchor's by at most half a turn.
double lonNear(double lonDeg, double anchorDeg);

/// Whether a point lies inside a ring, straight edges in longitude and latitude.
bool contains(std::span<const GeoPoint> ring, GeoPoint point);

/// Whether two rings have land in common, or touch.
bool meet(std::span<const GeoPoint> a, std::span<const GeoPoint> b);

/// In metres on a sphere: good enough to tell which of two things is nearer.
double roughDistanceM(GeoPoint a, GeoPoint b);

}  // namespace furrow
