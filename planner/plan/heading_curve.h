#pragma once

#include "planner/plan/plan.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

/// One heading with its figures in the mainland of a plan.
struct HeadingTrial {
    Angle heading;           ///< modulo pi
    HeadingFigures figures;  ///< of the layout that is quickest
    Duration turning;        ///< part of the time: turns between swaths
    Area missed;             ///< of the mainland, with flat ends
    /// No other heading is at least as good in time, overlap and missed area, and better in one of them.
    bool isTradeOff = false;
};

/// The figures of all headings.
struct HeadingCurve {
    std::vector<HeadingTrial> trials;  ///< by rising bearing (lineBearingDeg), one a degree and those below
    std::size_t chosen = 0;            ///< the heading of the plan
    std::size_t quickest = 0;          ///< the least time
    std::optional<std::size_t> longestEdge;  ///< along the longest edge of the field, or of the mainland
};

/// What other headings would give in the mainland of a finished plan, to and fro, by the model of the search
/// (ScanLine). It holds for this headland: one that depends on the heading would change with it. Empty where
/// the swaths have no heading in common: curves, circles, rows, headings of cells. Cancelled. Cost: 180 times
/// ScanLine::figures, on all threads.
Result<std::optional<HeadingCurve>> headingCurve(const Plan& plan, const JobContext& job = {});

}  // namespace furrow
