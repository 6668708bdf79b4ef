#pragma once

#include "planner/geometry/averaging_windows.h"
#include "planner/geometry/curve.h"
#include "planner/geometry/given_line.h"

#include <span>
#include <vector>

namespace furrow {

/// A piece of the eased line, and the stretch of the given line in the place of which it is driven.
struct EasedPiece {
    Pose start;
    CurvePiece piece;
    Pose was;  ///< of the given line at `fromM`
    double fromM = 0.0;
    double toM = 0.0;
    bool isSame = false;  ///< on the given line

    friend bool operator==(const EasedPiece&, const EasedPiece&) = default;
};

struct EasedLine {
    std::vector<EasedPiece> pieces;
    /// Each from one place of the given line that is kept to the next.
    std::vector<LineRange> bends;
    /// Bends for which no line was found between the same ends. There `pieces` are those of the given line.
    std::vector<LineRange> failed;
};

/// Lines, each of which begins where the one before ends, with a curvature that changes gradually. The
/// curvature at each place becomes its mean over the window there. So no bend gets sharper, and with windows
/// of w a change by k takes the way w. The line moves to the inside of bends, by k w² / 24 for long ones.
/// Straights stay where they are: between the middles of two straights longer than the window, lengths and
/// curvatures change by as little as brings the line back. (Least squares, Newton; ends exact to a
/// micrometre.) In long bends the same holds for the mean position every 20 m and more, where the bend is
/// gentle.
///
/// Where the gear changes the curvature is averaged in the order of driving, as the steering turns.
///
/// @param lines     of straights, arcs and clothoids in any gear. Pieces end where a line ends.
/// @param sharpest  bound of all curvatures
/// Cost: some ten microseconds for each bend.
EasedLine eased(std::span<const Curve> lines, const AveragingWindows& windows, Curvature sharpest);

/// The same line eased several times. Bends for which the windows did not change since the time before are
/// taken from there, to the last bit. May be moved, not used by several threads at once.
class LineEasing {
public:
    LineEasing(std::span<const Curve> lines, Curvature sharpest);

    EasedLine with(const AveragingWindows& windows);

    /// A bend before and after it was eased.
    struct Bend {
        std::vector<EasedPiece> before;
        Pose goal;
        std::vector<EasedPiece> after;
        bool failed = false;
    };

private:
    GivenLine line_;
    Curvature sharpest_;
    std::vector<Bend> known_;  ///< in the order of the line
};

}  // namespace furrow
