#pragma once

#include "planner/machine/machine.h"
#include "planner/path/path.h"
#include "planner/settings/operation.h"

#include <cstddef>
#include <optional>
#include <span>

namespace furrow {

/// What work does to a tank or bunker. A tank is full before it is used and after each stop, a bunker empty.
struct TankWork {
    double capacity = 0.0;
    double perMetre = 0.0;  ///< of way with the implement down, not negative
    bool gathers = false;   ///< a bunker that fills; otherwise a tank that empties

    friend bool operator==(const TankWork&, const TankWork&) = default;
};

/// The whole operating width counts, also where land is worked twice. Empty if the machine has no tank with a
/// rate, or the operation uses none.
std::optional<TankWork> tankWork(const Machine& machine, const Operation& operation);

/// Writes the level to each sample. It stays where it is once the tank is empty or the bunker full.
/// @return by how much the work between two stops goes beyond the capacity at most; 0 if it never does
double addLevels(Path& path, const TankWork& work);

/// What a segment of kind Refill is called: it leads to a refill point, or back to work. Cost: O(segments of
/// the trip).
Message tripName(std::span<const PathSegment> segments, std::size_t segment, bool gathers);

}  // namespace furrow
