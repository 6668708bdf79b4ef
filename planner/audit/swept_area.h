#pragma once

#include "planner/audit/audited_land.h"
#include "planner/audit/motion.h"

namespace furrow {

/// A missed area within reach above this share of the workable area, or above this area in one piece, is too
/// much.
inline constexpr double kMissedShare = 0.01;
inline constexpr Area kMissedPiece = squareMetres(100.0);

/// A part of the area that the working line sweeps in one step.
struct SweptPiece {
    Ring ring;  ///< counter-clockwise, convex except for rounding
    std::size_t segment = 0;
};

/// The area that the working line sweeps, and its effect on the field.
struct SweptArea {
    std::vector<SweptPiece> pieces;  ///< in driving order
    MultiPolygon missed;             ///< part of the workable area, largest first
    Area covered;
    Area missedArea;
    Area overlap;
    MultiPolygon overlapAreas;  ///< largest first
    Area overlapHeadland;
    Area error;
    std::optional<double> coveredOfReachable;  ///< empty without a machine
    /// Missed although within reach and to be worked, largest first. Without the strip kept for turning and
    /// the ends of the lanes beside it.
    MultiPolygon dropped;
    Area droppedArea;
    /// Missed and to be worked, but out of reach of this machine's working line, largest first.
    MultiPolygon beyondReach;
    Area beyondReachArea;
    MultiPolygon strip;  ///< kept for turning and not worked, largest first
    Area stripArea;
    Area leftOnPurpose;  ///< and not swept
    Area laneEnds;       ///< missed at the ends of the lanes, beside that strip
};

/// @param land  of this input
Result<SweptArea> measureSweptArea(const AuditInput& input, const AuditedLand& land,
                                   const MachineShape& shape, const std::vector<SegmentMotion>& motions,
                                   const JobContext& job);

/// The direction of the longest straight step of the implement, up or right, as a unit vector. Rounded
/// so that plans along the same swaths have the same, but by too little to leave the swaths.
Point mainDirection(const std::vector<SegmentMotion>& motions);

}  // namespace furrow
