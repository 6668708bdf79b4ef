#pragma once

#include "planner/machine/machine.h"
#include "planner/swaths/swath.h"

#include <array>
#include <cstddef>
#include <vector>

namespace furrow {

/// Which pieces are one cell: a cell for each piece, named by its first.
using Groups = std::vector<std::size_t>;

/// Estimates how long turning takes where the mainland is driven cell after cell: to and fro within each, and from
/// the end of one to the begin of the next, all by the shortest forward curves of free space at the speed for turns.
/// Cells follow on each other quickest way first (greedy matching of their corners); then stretches of the sequence are
/// turned round while that is quicker, and each cell begins at the side that suits its neighbours best.
///
/// Measured on finished plans of fields with many holes, turns within cells take what such a curve takes, and ways
/// between cells do within a sixth.
class CellCost {
public:
    /// @param swaths  straight, in the heading of the set or along lines of their own
    /// @param pieces  indices into the swaths, in their order; at most one swath of each line in a cell
    /// Cost: O(n²) for n pieces with swaths.
    CellCost(const SwathSet& swaths, const Machine& machine, std::vector<std::vector<std::size_t>> pieces);

    /// Cost: O(n²) for up to 200 pieces, O(n) for more: their sequence is left as it was matched.
    Duration of(const Groups& groups) const;

    bool isEmpty(std::size_t piece) const { return pieces_[piece].swaths.empty(); }

private:
    /// Where a swath is left or driven onto: 2 × swath + 1 at its end, 2 × swath at its start.
    using Port = std::size_t;
    /// The seconds that driving to and fro takes, by the side at which the first swath begins.
    using BySide = std::array<double, 2>;

    struct Piece {
        std::vector<std::size_t> swaths;
        BySide turning{};
    };
    /// A corner of a piece: 4 × piece, 2 more at its last swath, 1 more at the end of that swath.
    using Corner = std::size_t;
    /// Between two corners of different pieces that are near each other.
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

        /// The side of the last swath that is reached from one of the first, or the other way round.
        std::size_t across(std::size_t side) const { return isOdd ? 1 - side : side; }
    };
    /// A cell as it is driven in a sequence.
    struct Visit {
        std::size_t cell;
        bool fromLast;
        std::size_t side;  ///< of its first swath
    };

    double linkSeconds(Port leaving, Port arriving) const;
    std::size_t swathAt(Corner corner) const;
    double cornerSeconds(Corner leaving, Corner arriving) const;
    void findLinks();
    void findRoughSeconds();
    std::vector<Cell> cellsOf(const Groups& groups) const;
    std::vector<Visit> sequenceOf(const std::vector<Cell>& cells) const;
    Corner entered(const std::vector<Cell>& cells, const Visit& visit) const;
    Corner left(const std::vector<Cell>& cells, const Visit& visit) const;
    double secondsOf(const std::vector<Cell>& cells, const std::vector<Visit>& sequence) const;
    static void turnRound(std::vector<Visit>& sequence, std::size_t first, std::size_t last);
    /// By straight ways where ends are not near each other.
    void improveRoughly(const std::vector<Cell>& cells, std::vector<Visit>& sequence) const;
    /// By the ways themselves.
    void improve(const std::vector<Cell>& cells, std::vector<Visit>& sequence, double& seconds) const;

    const SwathSet& swaths_;
    const Machine& machine_;
    std::vector<Piece> pieces_;
    std::vector<Link> links_;  ///< the quickest first
    /// Between all corners of pieces; empty where these are too many.
    std::vector<double> roughSeconds_;
    bool areFew_ = true;
};

}  // namespace furrow
