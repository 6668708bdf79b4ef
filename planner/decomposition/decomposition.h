#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/method.h"
#include "planner/settings/settings.h"
#include "planner/swaths/swath.h"

#include <cstddef>
#include <vector>

namespace furrow {

/// One piece of the mainland; its swaths are driven together.
struct Cell {
    MultiPolygon outline;
    std::vector<std::size_t> swaths;  ///< indices into the swath set, in its order
    Angle heading;                    ///< of its swaths, modulo pi
};

/// Two cells that become one, each named by its first piece.
struct Join {
    std::size_t kept = 0;
    std::size_t gone = 0;

    friend bool operator==(const Join&, const Join&) = default;
};

/// One state between the pieces as they were cut and the cells that are driven.
struct DecompositionStep {
    std::vector<Join> joins;  ///< that led here: one that lowered the cost, or all those with cells without swaths that
                              ///< came one after the other
    std::size_t cells = 0;
    Length altitude;  ///< sum of the cells' extents across the heading
    Duration cost;    ///< of turns and of ways from cell to cell, estimated: see CellCost
};

/// How cells came about.
struct DecompositionHistory {
    MultiPolygon pieces;                   ///< as cut: cells are made of them
    std::vector<DecompositionStep> steps;  ///< as cut, then what was joined; none where nothing was estimated
};

/// The mainland in cells.
struct Decomposition {
    std::vector<Cell> cells;  ///< from right to left of the swath heading; some may have no swath
    Length altitude;          ///< sum of the cells' extents across the heading
    DecompositionHistory history;
};

/// What cells are made from; nothing of it is kept.
struct DecompositionTask {
    const MultiPolygon& mainland;
    const SwathSet& swaths;  ///< of all of the mainland, in one heading
    const Machine& machine;
    const Settings& settings;
};

/// The common signature of all decompositions: the cells tile the mainland. Swaths are not cut: each lies in one
/// cell as it is. Cancelled. Cost: O(n) edges for each of the corners that are cut at, and one GEOS noding.
using Decomposer = Result<Decomposition>(const DecompositionTask& task, const JobContext& job);

/// Lines along which the mainland is cut before any of these divides it.
extern const Parameter kSplit;
/// Whether all cells have one heading.
extern const Parameter kCellHeading;

extern const Method<Decomposer> kOnePieceMethod;
/// Cut along the heading at every corner (Chazelle 1987).
extern const Method<Decomposer> kTrapezoidalMethod;
/// Cut only where the number of pieces of a line across the mainland changes (Choset & Pignon 1998,
/// doi 10.1007/978-1-4471-1273-0_32).
extern const Method<Decomposer> kBoustrophedonCellsMethod;
/// The same, then every two cells that lie one above the other are joined where that lowers the estimated time for turns
/// and for ways from cell to cell (DESIGN 32).
extern const Method<Decomposer> kMergedCellsMethod;

}  // namespace furrow
