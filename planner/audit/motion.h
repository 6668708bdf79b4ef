#pragma once

#include "planner/audit/audit.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// The place of tractor and implement at one instant.
struct MotionState {
    Point position;  ///< of the reference point
    double headingRad = 0.0;
    Point nose;       ///< unit vector of the heading
    Point implement;  ///< middle of the working line
    double implementHeadingRad = 0.0;
    Point implementNose;
};

/// The states of one segment. They are close enough that straight steps between them stay within kChordErrorM
/// of the true curve everywhere on the machine. They include exact copies of the samples.
struct SegmentMotion {
    std::vector<MotionState> states;
    /// A turn on the spot at its first state, from the end of the segment before.
    std::vector<MotionState> turnOnTheSpot;
    double largestHitchAngleRad = 0.0;
    Point largestHitchAnglePlace;
};

/// The segment as which the machine turns on the spot at the beginning of one: the one before if that has the
/// implement up, since it is lowered at the end of the turn.
inline std::size_t turnsOnTheSpotAs(std::span<const PathSegment> segments, std::size_t segment) {
    return segment > 0 && !segments[segment - 1].implementDown ? segment - 1 : segment;
}

/// Largest distance between a curve and its chords, on any part of the machine, m.
inline constexpr double kChordErrorM = 0.01;

/// The places of the parts around the reference point.
struct MachineShape {
    double operatingWidthM = 0.0;
    double implementOffsetM = 0.0;
    double lateralOffsetM = 0.0;
    double hitchOffsetM = 0.0;
    std::optional<double> trailingM;  ///< from hitch to working line; empty if mounted
    double reachM = 0.0;              ///< largest distance of any part from the reference point
    bool turnsOnTheSpot = false;
};

MachineShape shapeOf(const AuditInput& input);

/// Follows the whole path. O(states).
Result<std::vector<SegmentMotion>> followPath(const AuditInput& input, const MachineShape& shape,
                                              const JobContext& job);

}  // namespace furrow
