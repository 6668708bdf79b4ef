#pragma once

#include "planner/plan/plan.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

/// What two plans of a field are compared by.
enum class Figure {
    Time,
    Path,
    Working,
    Turning,
    Mainland,
    Swaths,
    Covered,
    Missed,
    Overlap,
    Outside,
    Reversed,
    Problems
};
inline constexpr std::array kFigures{Figure::Time,     Figure::Path,    Figure::Working,  Figure::Turning,
                                     Figure::Mainland, Figure::Swaths,  Figure::Covered,  Figure::Missed,
                                     Figure::Overlap,  Figure::Outside, Figure::Reversed, Figure::Problems};

/// What is said of more and less of it.
enum class Better { Less, More, Neither };
Better betterOf(Figure figure);

/// Time in s, lengths in m, areas in m², numbers. Empty where the plan was not measured.
std::optional<double> figureOf(const Plan& plan, Figure figure);

/// Which plan is better by a figure: -1 the first, 1 the second, 0 for no difference that anybody would see
/// (a second, a metre, a square metre) and for figures of which neither more nor less is better.
int better(Figure figure, std::optional<double> first, std::optional<double> second);

/// A setting that two plans have different values of.
struct SettingDifference {
    const Parameter* parameter = nullptr;
    SettingValue first;
    SettingValue second;
};

/// A stretch that is driven in one of two plans only.
struct DifferentStretch {
    bool worked = false;      ///< of a headland pass; otherwise of a turn or another way between worked lines
    std::vector<Point> line;  ///< two points or more, in the field's local frame

    Length length() const;
};

/// The length of all worked stretches, or of all others.
Length lengthOf(const std::vector<DifferentStretch>& stretches, bool worked);

/// What is not the same in two plans of one field.
struct PlanDifference {
    bool machine = false;  ///< the machines differ
    std::vector<SettingDifference> settings;
    /// Swaths that lie in one of the plans only, by index in its SwathSet.
    std::vector<std::size_t> onlyInFirst;
    std::vector<std::size_t> onlyInSecond;
    /// Headland passes and ways between worked lines, as far as the other plan has none there. In the order
    /// of the path.
    std::vector<DifferentStretch> drivenOnlyInFirst;
    std::vector<DifferentStretch> drivenOnlyInSecond;
};

/// Two swaths are the same where their ends lie within 0.1 m, driven either way, and their middles do.
/// A headland pass is in the other plan as far as a pass of that lies within 0.1 m and runs along, either
/// way; likewise the ways between worked lines. Cost: O(n m) for n and m swaths, O(p log p) for paths of p
/// samples. Some milliseconds for thousands of swaths, some tenths of a second for paths of hundreds of
/// kilometres: not for a thread that draws.
PlanDifference differenceOf(const Plan& first, const Plan& second);

}  // namespace furrow
