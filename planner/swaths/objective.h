#pragma once

#include "planner/settings/settings.h"
#include "planner/units/quantity.h"

namespace furrow {

/// The measure that compares headings. Count, length and coverage are the paper's. Lengths are compared with
/// the missed area added as metres, since a heading that leaves more out drives less.
enum class SwathObjective { Time, Count, Length, Coverage, Overlap };

/// Land that no swath covers takes so many times as long as in swaths: it is worked in small pieces.
inline constexpr double kPiecemealFactor = 5.0;

/// Every objective of one heading.
struct HeadingFigures {
    int count = 0;          ///< swaths
    Length length;          ///< of all swaths
    double coverage = 0.0;  ///< A_cov, flat ends
    Area overlap;           ///< of the mainland, covered at least twice
    Length missed;          ///< area not covered, as metres of a full-width swath
    /// Time to work the mainland to and fro: swaths, turns between them, and the missed area. The missed area
    /// counts as if worked in pieces (kPiecemealFactor). Only if time is the objective.
    Duration time;
};

/// Whether a is strictly better than b. Ties are broken by coverage, then by fewer metres.
bool isBetter(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b);

/// Whether a is no worse than b by this objective alone, except for rounding.
bool isAsGood(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b);

/// Whether the lines alone decide this objective.
constexpr bool isOfLines(SwathObjective objective) {
    return objective == SwathObjective::Count;
}

/// The objective of a search for the best heading.
extern const Parameter kObjective;

/// The objective in the settings.
SwathObjective objectiveOf(const Settings& settings);

}  // namespace furrow
