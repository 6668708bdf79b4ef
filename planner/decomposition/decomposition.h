#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/settings/method.h"
#include "planner/settings/settings.h"
#include "planner/swaths/swath.h"

#include <array>

#include <cstddef>
#include <vector>

namespace furrow {

/// One piece of the mainland; its swaths are driven together.
struct Cell {
    MultiPolygon outline;
    std::vector<std::size_t> swaths;  ///< indices into the swath set, in its order
    Angle heading;                    ///< of its swaths, modulo pi

    friend bool operator==(const Cell&, const Cell&) = default;
};

/// Two cells that become one, each named by its first piece.
struct Join {
    std::size_t kept = 0;
    std::size_t gone = 0;

    friend bool operator==(const Join&, const Join&) = default;
};

/// One state between the cut pieces and the driven cells.
struct DecompositionStep {
    std::vector<Join> joins;  ///< one that lowered the cost, or all successive ones with cells without swaths
    std::size_t cells = 0;
    Length altitude;  ///< sum of the cells' extents across the heading
    Duration cost;    ///< estimated cost of turns and of ways between cells: see CellCost
};

/// The history of the cells.
struct DecompositionHistory {
    MultiPolygon pieces;                   ///< as cut, before any join
    std::vector<DecompositionStep> steps;  ///< as cut, then after each join; empty without an estimate
};

/// The mainland in cells.
struct Decomposition {
    std::vector<Cell> cells;  ///< from right to left of the swath heading; some may have no swath
    Length altitude;          ///< sum of the cells' extents across the heading
    DecompositionHistory history;
};

/// The inputs of cells. The cells keep none of them.
struct DecompositionTask {
    const MultiPolygon& mainland;
    const SwathSet& swaths;  ///< of the whole mainland, in one heading
    const Machine& machine;
    const Settings& settings;
};

/// The common signature of all decompositions: the cells tile the mainland. Swaths are not cut: each lies in
/// one cell unchanged. Cancelled. Cost: O(n) edges for each corner with a cut, and one GEOS noding.
using Decomposer = Result<Decomposition>(const DecompositionTask& task, const JobContext& job);

template <>
struct MethodTraits<Decomposer> {
    bool joinsCells = false;  ///< of a finer division, with its steps as history
};

/// Lines along which the mainland is cut first, before any of these methods divides it.
extern const Parameter kSplit;
/// Whether all cells have one heading.
extern const Parameter kCellHeading;
/// Whether each cell may have a heading of its own.
bool hasHeadingPerCell(const Settings& settings);

extern const Method<Decomposer> kOnePieceMethod;
/// Cut along the heading at every corner (Chazelle 1987).
extern const Method<Decomposer> kTrapezoidalMethod;
/// Cut only where the number of pieces of a line across the mainland changes (Choset & Pignon 1998,
/// doi 10.1007/978-1-4471-1273-0_32).
extern const Method<Decomposer> kBoustrophedonCellsMethod;
/// The same. Then two cells, one above the other, are joined if that lowers the estimated time for turns and
/// for ways between cells (DESIGN 32).
extern const Method<Decomposer> kMergedCellsMethod;

/// Every method of the stage, the default first.
inline constexpr std::array kDecompositionMethods{
    &kMergedCellsMethod,
    &kBoustrophedonCellsMethod,
    &kTrapezoidalMethod,
    &kOnePieceMethod,
};

}  // namespace furrow
