#pragma once

#include "planner/audit/motion.h"

namespace furrow {

/// More missed within reach than this share of the workable area, or than this in one piece, is too much.
inline constexpr double kMissedShare = 0.01;
inline constexpr Area kMissedPiece = squareMetres(100.0);

/// A part of what the working line sweeps in one step.
struct SweptPiece {
    Ring ring;  ///< counter-clockwise, convex but for rounding
    std::size_t segment = 0;
};

/// What the working line sweeps, and what that does to the field.
struct SweptArea {
    std::vector<SweptPiece> pieces;  ///< in driving order
    MultiPolygon missed;             ///< of the workable area, largest first
    Area covered;
    Area missedArea;
    Area overlap;
    MultiPolygon overlapAreas;       ///< largest first
    Area overlapHeadland;
    Area error;
    std::optional<double> coveredOfReachable;  ///< empty without a machine
    /// Missed although it is within reach and was to be worked, largest first: without the strip that is kept
    /// for turning and the ends of the lanes beside it.
    MultiPolygon dropped;
    Area droppedArea;
    /// Missed and to be worked, but where this machine cannot get with its working line, largest first.
    MultiPolygon beyondReach;
    Area beyondReachArea;
    MultiPolygon strip;  ///< kept for turning and not worked, largest first
    Area stripArea;
    Area leftOnPurpose;  ///< and not swept
    Area laneEnds;  ///< missed at the ends of the lanes, beside that strip
};

Result<SweptArea> measureSweptArea(const AuditInput& input, const MachineShape& shape,
                                   const std::vector<SegmentMotion>& motions, const JobContext& job);

/// The direction in which most of the driving is done, as a unit vector.
Point mainDirection(const std::vector<SegmentMotion>& motions);

}  // namespace furrow
