#pragma once

#include "planner/turns/pose.h"
#include "planner/units/quantity.h"

#include <string_view>
#include <vector>

namespace furrow {

enum class Gear { Forward = 1, Reverse = -1 };

/// A stretch of constant curvature in one gear.
struct TurnPiece {
    Length length;        ///< driven, not negative
    Curvature curvature;  ///< positive to the left along the nose
    Gear gear = Gear::Forward;

    friend bool operator==(const TurnPiece&, const TurnPiece&) = default;
};

/// A manoeuvre from one pose to another.
struct Turn {
    std::string_view type;  ///< "dubins", "straight"
    /// Where it begins; its heading differs from the pose it was asked for only where the vehicle turns in
    /// place.
    Pose start;
    std::vector<TurnPiece> pieces;

    Length length() const;
    /// Where it ends, by driving its pieces.
    Pose end() const;
    friend bool operator==(const Turn&, const Turn&) = default;
};

/// The pose after driving `way` along one piece from `from`. Exact for arcs and lines.
Pose advanced(const Pose& from, const TurnPiece& piece, Length way);

}  // namespace furrow
