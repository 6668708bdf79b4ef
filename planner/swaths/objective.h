#pragma once

#include "planner/settings/settings.h"
#include "planner/units/quantity.h"

namespace furrow {

/// What makes one heading better than another. Count, length and coverage are the paper's; but lengths are compared at
/// equal coverage, with what is missed as metres on top: less is driven the more is left out.
enum class SwathObjective { Time, Count, Length, Coverage, Overlap };

/// Every objective of one heading.
struct HeadingFigures {
    int count = 0;          ///< swaths
    Length length;          ///< of all swaths
    double coverage = 0.0;  ///< A_cov, flat ends
    Area overlap;           ///< of the mainland, covered at least twice
    Length missed;          ///< what is not covered, as metres of a full-width swath
    /// To work the mainland to and fro: swaths, the turns between them, and what stays missed as if it were
    /// worked piecemeal at a fifth of the pace. Only where time is the objective.
    Duration time;
};

/// Whether a is strictly better than b; ties are broken by coverage, then by fewer metres.
bool isBetter(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b);

/// Whether a is no worse than b by this objective alone, rounding aside.
bool isAsGood(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b);

/// The number of swaths says it all.
constexpr bool isOfLines(SwathObjective objective) {
    return objective == SwathObjective::Count;
}

/// What a search for the best heading looks for.
extern const Parameter kObjective;

/// The objective that the settings name.
SwathObjective objectiveOf(const Settings& settings);

}  // namespace furrow
