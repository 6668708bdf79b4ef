#pragma once

#include "planner/geometry/pose.h"
#include "planner/units/quantity.h"

#include <string_view>
#include <vector>

namespace furrow {

enum class Gear { Forward = 1, Reverse = -1 };

/// A stretch in one gear: a line, an arc, or a clothoid. The curvature of a clothoid changes evenly along the
/// way. Or a turn on the spot, which has no length.
struct CurvePiece {
    Length length;                       ///< driven, not negative
    Curvature curvature;                 ///< at its beginning; positive to the left along the nose
    Curvature endCurvature = curvature;  ///< at its end; the same for lines and arcs
    Gear gear = Gear::Forward;
    Angle onTheSpot = {};  ///< turned standing, positive to the left; 0 for stretches with a length

    Curvature curvatureAt(Length way) const;

    friend bool operator==(const CurvePiece&, const CurvePiece&) = default;
};

/// A manoeuvre from one pose to another.
struct Curve {
    std::string_view type;  ///< of the manoeuvre: "dubins", "straight", "omega"
    /// The start pose. Its heading differs from the requested pose only if the vehicle turns in place.
    Pose start;
    std::vector<CurvePiece> pieces;

    Length length() const;
    /// The end pose after all pieces.
    Pose end() const;
    friend bool operator==(const Curve&, const Curve&) = default;
};

/// The pose after driving `way` along one piece from `from`, exact except for rounding. Lines and arcs are in
/// closed form. Clothoids use Gauss-Legendre quadrature, with an error below 1e-15 of the way. About 20 ns
/// for an arc, 200 ns for each radian of a clothoid.
Pose advanced(const Pose& from, const CurvePiece& piece, Length way);

}  // namespace furrow
