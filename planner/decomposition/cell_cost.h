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
/// Cells follow on each other quickest way first (greedy matching of their ends); then stretches of the sequence are
/// turned round while that is quicker, and each cell begins at the side that suits its neighbours best.
///
/// Measured on finished plans of fields with many holes, turns within cells take what such a curve takes, and ways
/// between cells do within a sixth.
class CellCost {
public:
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
    /// Two ends of pieces that are near each other: 2 × piece + 1 at its last swath, 2 × piece at its first.
    struct Link {
        double seconds;
        std::size_t from;
        std::size_t to;
    };
    struct Cell {
        std::size_t firstPiece;
        std::size_t lastPiece;
        std::size_t firstSwath;
        std::size_t lastSwath;
        bool isOdd;
        BySide turning;
    };
    /// A cell as it is driven in a sequence.
    struct Visit {
        std::size_t cell;
        bool fromLast;
    };

    double linkSeconds(Port leaving, Port arriving) const;
    double endsSeconds(std::size_t end, std::size_t other) const;
    void findLinks();
    void findRoughSeconds();
    std::vector<Cell> cellsOf(const Groups& groups) const;
    std::vector<Visit> sequenceOf(const std::vector<Cell>& cells) const;
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
    /// Between all ends of pieces; empty where these are too many.
    std::vector<double> roughSeconds_;
    bool areFew_ = true;
};

}  // namespace furrow
