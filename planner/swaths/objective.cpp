#include "planner/swaths/objective.h"

#include <cmath>

namespace furrow {

namespace {

constexpr Choice kObjectives[] = {
    {"time", "Least time", "The shortest time in swaths and turns."},
    {"swath-count", "Fewest swaths", "As few swaths, and so turns, as possible."},
    {"swath-length", "Shortest swaths",
     "The least metres driven in swaths, with what is missed added as metres."},
    {"coverage", "Most covered", "The largest covered share inside the headland."},
    {"overlap", "Least overlap", "The smallest area worked twice."},
};

// Smaller differences are rounding.
constexpr double kLengthSlackM = 1e-6;
constexpr double kAreaSlackM2 = 1e-6;
constexpr double kTimeSlackS = 1e-6;
constexpr double kCoverageSlack = 1e-12;

/// Positive if a is better, negative if b is, zero for rounding.
double advantage(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b) {
    const auto beyond = [](double difference, double slack) {
        return std::abs(difference) > slack ? difference : 0.0;
    };
    switch (objective) {
        case SwathObjective::Time: return beyond((b.time - a.time).si(), kTimeSlackS);
        case SwathObjective::Count: return b.count - a.count;
        case SwathObjective::Length:
            return beyond((b.length + b.missed - a.length - a.missed).si(), kLengthSlackM);
        case SwathObjective::Coverage: return beyond(a.coverage - b.coverage, kCoverageSlack);
        case SwathObjective::Overlap: return beyond((b.overlap - a.overlap).si(), kAreaSlackM2);
    }
    return 0.0;
}

}  // namespace

bool isAsGood(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b) {
    if ((a.count == 0) != (b.count == 0)) {
        return b.count == 0;
    }
    return advantage(objective, a, b) >= 0.0;
}

bool isBetter(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b) {
    // A heading whose lines miss the mainland completely is never an answer.
    if ((a.count == 0) != (b.count == 0)) {
        return b.count == 0;
    }
    for (const SwathObjective criterion : {objective, SwathObjective::Coverage, SwathObjective::Length}) {
        if (const double better = advantage(criterion, a, b); better != 0.0) {
            return better > 0.0;
        }
    }
    return false;
}

const Parameter kObjective{.key = "swaths.objective",
                           .name = "Prefer",
                           .description = "What the search for the best heading looks for.",
                           .kind = ParameterKind::Choice,
                           .standard = 0.0,
                           .choices = kObjectives};

SwathObjective objectiveOf(const Settings& settings) {
    const std::string id = settings.choice(kObjective);
    return id == "swath-count"    ? SwathObjective::Count
           : id == "swath-length" ? SwathObjective::Length
           : id == "coverage"     ? SwathObjective::Coverage
           : id == "overlap"      ? SwathObjective::Overlap
                                  : SwathObjective::Time;
}

}  // namespace furrow
