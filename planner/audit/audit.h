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

// The audit measures a finished path with independent code. It reads the field's polygons, the machine and
// the samples of the path. It does not know how they were made.

/// A place on the boundary that the footprint may cross.
struct AuditGate {
    Point position;
    Length width;
};

/// The tank or bunker whose level a path states, and where it is filled or emptied.
struct AuditTank {
    bool gathers = false;  ///< a bunker; otherwise a tank
    std::vector<Point> points;
    Length reach;  ///< the machine stops no farther from a point than this

    friend bool operator==(const AuditTank&, const AuditTank&) = default;
};

/// A pass that the plan promises. It must be found on the path.
struct PlannedPass {
    Polyline line;  ///< middle of the worked lane
    Length width;
    int number = 0;  ///< as people see it
    SegmentKind kind = SegmentKind::Swath;
};

/// A finished path and the data to measure it against, all in the field's local frame.
struct AuditInput {
    MultiPolygon workable;  ///< to be worked: valid, not overlapping
    MultiPolygon drivable;  ///< may be driven on
    /// Where the implement may stand, if not only there. Holds the drivable area. The tractor and all wheels
    /// stay in that.
    std::optional<MultiPolygon> overhung = {};
    std::vector<AuditGate> gates;
    /// Without a machine, the lane has the width of the planned passes and the footprint is not checked.
    std::optional<Machine> machine;
    std::span<const PathSegment> segments;  ///< in driving order; must outlive the call
    std::vector<PlannedPass> passes;
    /// The area that the plan was to work, if the rest of the workable area is kept for turning and never
    /// driven. That rest is then one note, not a missed area.
    std::optional<MultiPolygon> mainland;
    /// Distance that everything keeps from the edge of the drivable area: land that is given away.
    Length margin;
    /// Other land that the plan leaves on purpose: wet spots, alleys, gaps. May overlap.
    MultiPolygon leftOnPurpose;
    /// With a machine that has a tank: its level is followed.
    std::optional<AuditTank> tank = {};
    /// The user let connections leave the field: reported as a note.
    bool mayLeaveField = false;
    /// Headings, speeds and times are stated. If false, only positions are, and only areas, clearance and
    /// gaps are measured.
    bool statedMotion = true;
    /// Largest error of a position from rounding in a file.
    Length positionRounding;
};

/// A finding with its segment.
struct AuditFinding {
    Finding finding;
    std::optional<std::size_t> segment;

    friend bool operator==(const AuditFinding&, const AuditFinding&) = default;
};

/// The figures of one plan. Figures that cannot be measured from the input stay empty.
struct AuditReport {
    Area workable;                             ///< area to be worked, in the plane
    std::optional<Area> covered;               ///< part of it swept by the implement while down
    std::optional<double> coveredShare;        ///< covered / workable
    std::optional<double> coveredOfReachable;  ///< share of the reachable area that is covered
    std::optional<Area> missed;                ///< of the workable area, neither swept nor left on purpose
    /// The part of the margin and of other land left on purpose that is not swept: neither missed nor within
    /// reach.
    std::optional<Area> leftOnPurpose;
    MultiPolygon missedAreas;  ///< largest first
    /// The part of these that is within reach and was to be worked, largest first, without thin strips; then
    /// its total area.
    MultiPolygon leftAreas;
    Area left;
    std::optional<Area> overlap;          ///< swept by at least two passes, inside the workable area
    MultiPolygon overlapAreas;            ///< largest first
    std::optional<Area> overlapHeadland;  ///< part of it between headland passes and swaths
    std::optional<Area> outside;          ///< swept by the footprint outside its area and gates
    std::optional<Length> minClearance;   ///< from the footprint to the edge of that area, negative outside
    /// Swept by the implement outside of drivable area and gates, and how far at most. 0 if it may not.
    Area overhangArea;
    Length overhang;
    std::optional<Curvature> maxCurvature;          ///< re-derived from the points, absolute
    std::optional<Curvature> maxCurvatureMismatch;  ///< between that and the stated curvature
    /// Largest change of the re-derived curvature. At a step of curvature: the step divided by the sample
    /// spacing.
    std::optional<CurvatureRate> maxCurvatureRate;
    std::optional<Length> maxPositionJump;
    std::optional<Angle> maxHeadingJump;
    std::optional<Angle> maxHitchAngle;  ///< between tractor and trailed implement
    Length reversed;                     ///< driven in reverse gear
    /// Distance of the reference point, implement up, over lanes that are worked before or after. The lanes
    /// at both ends of a connection do not count.
    Length drivenOnWorked;
    Length drivenOnUnworked;
    int mostWheelPasses = 0;             ///< over one square; both wheels of one passage count once
    std::vector<Bounds> oftenDriven;     ///< squares with more than 3 passages, neighbours in a row as one
    double oftenDrivenShare = 0.0;       ///< share of the workable area in squares with more than 3 passages
    Length wheelSquare;                  ///< side of these squares
    Area areaError;                      ///< error bound of the areas: chords instead of curves, rounding
    Length distanceError;                ///< error bound of clearance and jumps
    std::vector<AuditFinding> findings;  ///< blocking ones first, each group in driving order

    friend bool operator==(const AuditReport&, const AuditReport&) = default;
};

/// Measures a path.
///
/// Covered: the union of the area that the working line sweeps while down, inside the workable area. The
/// working line has the operating width and lies at the middle of the working parts.
/// Overlap: the area that it sweeps twice, also within one segment that turns more tightly than half its
/// width.
/// Reachable: the part of the workable area in the opening of the drivable area by a disc, that is, wherever
/// such a disc fits without leaving it. The disc has half the working footprint's width as radius. A strip
/// along the edge does not count where the tractor is broader than the implement between its ends. For a
/// machine that cannot reverse, its edge is the one that the outer end of the implement describes on full
/// lock.
/// A trailed implement follows the hitch on its own track (tractrix), straight behind at the start.
/// Left: the missed area within reach. If that would block the plan, and nothing trails, only the part that
/// the machine has room to work (WorkingRoom).
/// Blocking findings: outside, obstacle, curvature, jump, heading, missing-turn, reverse, dropped-swath,
/// dropped-pass, undrivable, folded (without standing for it), refill (work beyond what the tank holds, or
/// filled elsewhere than standing at a refill point), and missed area within reach above 1 % of the
/// workable area or 100 m² in one piece. Cost: O(samples log samples), one sweep over all passes and, with a
/// machine, two offsets of the field. Cancelled, within milliseconds. Deterministic for any thread count.
Result<AuditReport> audit(const AuditInput& input, const JobContext& job = {});

}  // namespace furrow
