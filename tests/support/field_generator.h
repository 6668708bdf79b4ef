#pragma once

#include "planner/field/field.h"
#include "planner/geometry/polygon.h"

#include <array>
#include <cstdint>
#include <random>
#include <string_view>

namespace furrow::test {

/// What a generated polygon looks like.
enum class Shape { Convex, Concave, Holes, Thin, Parts };

inline constexpr std::array kShapes{Shape::Convex, Shape::Concave, Shape::Holes, Shape::Thin, Shape::Parts};

std::string_view shapeName(Shape shape);

/// Valid polygons in metres, turned by a random angle and moved by up to a kilometre: outer rings
/// counter-clockwise, holes clockwise. The same seed gives the same polygons on every computer.
///
/// @param radiusM  no point is farther than this from the middle
MultiPolygon randomPolygons(std::mt19937_64& random, Shape shape, double radiusM);

/// Uniform in [low, high), the same on every computer (the standard's distributions need not be).
double uniform(std::mt19937_64& random, double low, double high);

/// Counter-clockwise from its lower left corner.
Polygon rectangle(double widthM, double heightM, Point lowerLeft = {});

/// The same, with its middle at the origin.
Polygon centredRectangle(double widthM, double heightM);

/// Turned around the origin, counter-clockwise, then moved.
MultiPolygon moved(const MultiPolygon& polygons, Angle turn, Point by);

/// A field whose boundary is these polygons, drawn in the local frame around `centre`.
FieldSource fieldSourceFromLocal(const MultiPolygon& polygons, GeoPoint centre);

}  // namespace furrow::test
