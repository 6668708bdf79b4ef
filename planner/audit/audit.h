#pragma once

#include "planner/core/result.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/path/finding.h"
#include "planner/path/path.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace furrow {

// The audit measures a finished path with code of its own: it reads the field's polygons, the machine and
// the samples of the path, and knows nothing of how they came about.

/// A place on the boundary that the footprint may cross.
struct AuditGate {
    Point position;
    Length width;
};

/// A pass that the plan promises: it must be found on the path.
struct PlannedPass {
    Polyline line;  ///< middle of the worked lane
    Length width;
    int number = 0;  ///< as people see it
    SegmentKind kind = SegmentKind::Swath;
};

/// A finished path and what it is measured against, all in the field's local frame.
struct AuditInput {
    MultiPolygon workable;  ///< to be worked: valid, not overlapping
    MultiPolygon drivable;  ///< may be driven on
    std::vector<AuditGate> gates;
    /// Without one the lane has the width of the planned passes and nothing is said of the footprint.
    std::optional<Machine> machine;
    std::span<const PathSegment> segments;  ///< in driving order; must outlive the call
    std::vector<PlannedPass> passes;
    /// What the plan was to work, where the rest of the workable area is kept for turning and driven over
    /// by nothing: that rest is then one note, not a missed area.
    std::optional<MultiPolygon> mainland;
    /// Kept from the edge of what may be driven on by everything: land that is given away.
    Length margin;
    /// Other land that the plan leaves on purpose: wet spots, alleys, gaps. May overlap.
    MultiPolygon leftOnPurpose;
    /// The user let connections leave the field: reported as a note.
    bool mayLeaveField = false;
    /// Headings, speeds and times are stated; otherwise only positions are, and only areas, clearance and
    /// gaps are measured.
    bool statedMotion = true;
    /// How far a position may be from the true one through rounding in a file.
    Length positionRounding;
};

/// A finding with the segment it is about.
struct AuditFinding {
    Finding finding;
    std::optional<std::size_t> segment;

    friend bool operator==(const AuditFinding&, const AuditFinding&) = default;
};

/// The figures of one plan. What cannot be measured from the input stays empty.
struct AuditReport {
    Area workable;                             ///< area to be worked, in the plane
    std::optional<Area> covered;               ///< of it, swept by the implement while down
    std::optional<double> coveredShare;        ///< covered / workable
    std::optional<double> coveredOfReachable;  ///< share of the reachable area that is covered
    std::optional<Area> missed;                ///< of the workable area, not swept, nor left on purpose
    /// Of the margin and what else is left on purpose, what is not swept: neither missed nor within reach.
    std::optional<Area> leftOnPurpose;
    MultiPolygon missedAreas;                  ///< largest first
    /// Of these what is within reach and was to be worked, largest first, hairs left out; and all of it.
    MultiPolygon leftAreas;
    Area left;
    std::optional<Area> overlap;               ///< swept by at least two passes, inside the workable area
    MultiPolygon overlapAreas;                 ///< largest first
    std::optional<Area> overlapHeadland;       ///< of it, between headland passes and swaths
    std::optional<Area> outside;            ///< swept by the footprint outside the drivable area, gates aside
    std::optional<Length> minClearance;     ///< of the footprint to the edge of that area, negative outside
    std::optional<Curvature> maxCurvature;  ///< re-derived from the points, absolute
    std::optional<Curvature> maxCurvatureMismatch;  ///< between that and what the samples state
    /// Largest change of the re-derived curvature; where the curvature has steps, step over sample spacing.
    std::optional<CurvatureRate> maxCurvatureRate;
    std::optional<Length> maxPositionJump;
    std::optional<Angle> maxHeadingJump;
    std::optional<Angle> maxHitchAngle;  ///< between tractor and trailed implement
    Length reversed;                     ///< driven in reverse gear
    /// Way of the reference point, implement up, over lanes that are worked before or after; the lanes that
    /// a connection leads from and to are not counted.
    Length drivenOnWorked;
    Length drivenOnUnworked;
    int mostWheelPasses = 0;             ///< over one square; both wheels of one passage count once
    std::vector<Bounds> oftenDriven;     ///< those with more than 3 passages, neighbours in a row as one
    double oftenDrivenShare = 0.0;       ///< of the workable area, in squares with more than 3 passages
    Length wheelSquare;                  ///< side of these squares
    Area areaError;                      ///< the areas are this exact: chords instead of curves, rounding
    Length distanceError;                ///< clearance and jumps are this exact
    std::vector<AuditFinding> findings;  ///< blocking ones first, each group in driving order

    friend bool operator==(const AuditReport&, const AuditReport&) = default;
};

/// Measures a path.
///
/// Covered: the union of what the working line (operating width, at the middle of the working parts) sweeps
/// while down, inside the workable area. Overlap: what it sweeps twice, also within one segment, where
/// it turns more tightly than half its width. Reachable: the
/// part of the workable area in the opening of the drivable area by a disc of half the working footprint's
/// width, that is, wherever such a disc fits without leaving it; of a machine that cannot reverse, by the disc whose
/// edge the outer end of its implement describes on full lock.
/// A trailed implement follows the hitch on its own track (tractrix), straight behind at the start.
/// Left: what is missed within reach; where that would block the plan, and nothing trails, only as far as the machine
/// has room to work there (WorkingRoom).
/// Findings are blocking for: outside, obstacle, curvature, jump, heading, missing-turn, reverse,
/// dropped-swath, dropped-pass, undrivable, and missed area within reach above 1 % of the workable area or
/// 100 m² in one piece.
/// Cost: O(samples log samples), one sweep over all passes and, with a machine, two offsets of the field.
/// Cancelled, within milliseconds. Deterministic, whatever the thread count.
Result<AuditReport> audit(const AuditInput& input, const JobContext& job = {});

}  // namespace furrow
