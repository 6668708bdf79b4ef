#pragma once

#include "planner/path/path_builder.h"
#include "planner/path/tank_levels.h"

#include <optional>
#include <vector>

namespace furrow {

/// Work that no trip to a refill point interrupts: legs that follow on each other, or a part of one.
struct RefillPiece {
    std::vector<Leg> legs;
    double uses = 0.0;    ///< from the tank
    bool goesOn = false;  ///< with the leg that the piece before begins
};

/// The pieces of all legs. A leg that takes more than a whole tank is cut where `mayCut` allows, in pieces of
/// a quarter of a tank at most.
std::vector<RefillPiece> refillPieces(const std::vector<Leg>& legs, const TankWork& work, bool mayCutSwaths);

/// The legs of all pieces, with these stops before some of them. Pieces of one leg without a stop in between
/// are one leg again.
/// @param stops  one for each piece; empty where none is
std::vector<Leg> legsWithStops(const std::vector<RefillPiece>& pieces,
                               const std::vector<std::optional<Leg>>& stops);

}  // namespace furrow
