#pragma once

#include "planner/machine/machine.h"
#include "planner/swaths/swath.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace furrow {

/// The cell of each piece. A cell is named by its first piece.
using Groups = std::vector<std::size_t>;

/// Estimates the time for turning if the mainland is driven cell after cell: to and fro within each cell, and
/// from the end of one to the beginning of the next. All turns are the shortest forward curves of free space
/// at the speed for turns. The sequence is first matched quickest way first (greedy matching of the cells'
/// corners). Then stretches of it are reversed while that is quicker. Each cell begins at the side that suits
/// its neighbours best.
///
/// Measured on finished plans of fields with many holes: turns within cells take the time of such a curve;
/// ways between cells are within a sixth of it.
class CellCost {
public:
    /// @param swaths  straight, in the heading of the set or along their own lines
    /// @param pieces  indices into the swaths, in their order; at most one swath of each line in a cell
    /// Cost: O(n²) for n pieces with swaths.
    CellCost(const SwathSet& swaths, const Machine& machine, std::vector<std::vector<std::size_t>> pieces);

    /// Cost: O(n²) for up to 200 pieces. O(n) for more: their sequence stays as matched.
    Duration of(const Groups& groups) const;

    bool isEmpty(std::size_t piece) const { return pieces_[piece].swaths.empty(); }

private:
    /// An end of a swath, for leaving it or driving onto it: 2 × swath + 1 at its end, 2 × swath at its
    /// start.
    using Port = std::size_t;
    /// The seconds for driving to and fro, by the side at which the first swath begins.
    using BySide = std::array<double, 2>;

    struct Piece {
        std::vector<std::size_t> swaths;
        BySide turning{};
    };
    /// A corner of a piece: 4 × piece, plus 2 at its last swath, plus 1 at the end of that swath.
    using Corner = std::size_t;
    /// A way between two corners of different pieces that are near each other.
    struct Link {
        double seconds;
        Corner from;
        Corner to;
    };
    struct Cell {
        std::size_t firstPiece;
        std::size_t lastPiece;
        std::size_t firstSwath;
        std::size_t lastSwath;
        bool isOdd;
        BySide turning;

        /// The side of the last swath that follows from a side of the first swath, or the reverse.
        std::size_t across(std::size_t side) const { return isOdd ? 1 - side : side; }
    };
    /// A cell in a sequence, with its direction.
    struct Visit {
        std::size_t cell;
        bool fromLast;
        std::size_t side;  ///< of its first swath
    };
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
    /// Ends of cells that are joined greedily, the quickest link first. An end is 2 × cell, or 2 × cell + 1
    /// at its last swath.
    struct MatchedEnds {
        std::vector<std::size_t> partner;  ///< of an end, or kNone
        std::vector<std::size_t> sides;    ///< of the first swath of a cell, once one of its ends is joined
    };

    double linkSeconds(Port leaving, Port arriving) const;
    std::size_t swathAt(Corner corner) const;
    double cornerSeconds(Corner leaving, Corner arriving) const;
    void findLinks();
    void findRoughSeconds();
    std::vector<Cell> cellsOf(const Groups& groups) const;
    std::vector<Visit> sequenceOf(const std::vector<Cell>& cells) const;
    MatchedEnds matchedEnds(const std::vector<Cell>& cells) const;
    Corner entered(const std::vector<Cell>& cells, const Visit& visit) const;
    Corner left(const std::vector<Cell>& cells, const Visit& visit) const;
    double secondsOf(const std::vector<Cell>& cells, const std::vector<Visit>& sequence) const;
    static void turnRound(std::vector<Visit>& sequence, std::size_t first, std::size_t last);
    /// Uses straight ways if ends are not near each other.
    void improveRoughly(const std::vector<Cell>& cells, std::vector<Visit>& sequence) const;
    /// Uses the exact ways.
    void improve(const std::vector<Cell>& cells, std::vector<Visit>& sequence, double& seconds) const;

    const SwathSet& swaths_;
    const Machine& machine_;
    std::vector<Piece> pieces_;
    std::vector<Link> links_;  ///< the quickest first
    /// Between all corners of pieces. Empty if there are too many pieces.
    std::vector<double> roughSeconds_;
    bool areFew_ = true;
};

}  // namespace furrow
