#pragma once

#include "planner/geometry/curve.h"

#include <cstddef>
#include <span>
#include <vector>

namespace furrow {

/// A stretch of the given line, in metres from its start.
struct LineRange {
    double fromM = 0.0;
    double toM = 0.0;
};

/// The largest way over which curvature is averaged, along lines. Between two places it is bounded by a value
/// for that stretch. It never changes by more than the way itself, and is 0 at both ends.
class AveragingWindows {
public:
    /// @param fromM  where each stretch begins, in metres from the start, ascending, the first 0
    /// @param mostM  of each stretch
    /// @param endM   of the last one
    AveragingWindows(std::span<const double> fromM, std::span<const double> mostM, double endM);

    /// O(log stretches).
    double at(double m) const;
    /// Up to this value, in metres, a line of 1 m radius and more moves by less than 2 mm.
    static constexpr double kKeptM = 0.2;
    /// Stretches whose value is so small. At their ends the line is tied to the given line.
    std::vector<LineRange> kept() const;
    /// Places where it begins to change otherwise.
    std::vector<double> kinks() const;

private:
    std::vector<double> placesM_;
    std::vector<double> limitsM_;  ///< at the places
    std::vector<double> mostM_;    ///< between a place and the next
};

/// A piece of the eased line, and the stretch of the given line in the place of which it is driven.
struct EasedPiece {
    Pose start;
    CurvePiece piece;
    Pose was;  ///< of the given line at `fromM`
    double fromM = 0.0;
    double toM = 0.0;
    bool isSame = false;  ///< on the given line
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

}  // namespace furrow
