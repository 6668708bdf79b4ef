#pragma once

#include "planner/geometry/polygon.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

// Internal to the outline of tracks: what a receiver recorded and nobody drove.

/// The positions of a track, in its order, by their numbers.
struct SteadyTrack {
    std::vector<std::size_t> kept;
    std::size_t jumps = 0;                 ///< positions left out
    std::optional<std::size_t> firstJump;  ///< of them
    /// Steps that are longer are breaks in the recording; infinite where long steps are how it was recorded.
    double longestStepM = 0.0;
};

/// Leaves out up to ten positions in a row that lie far off while those before and after them lie close
/// together. What is far is measured by the track's own steps, so a track of few positions far apart keeps
/// all of them. `times` are those of the places, in seconds. Cost: linear.
SteadyTrack withoutJumps(const Polyline& places, const std::vector<std::optional<double>>& times);

}  // namespace furrow
