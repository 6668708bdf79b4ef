#pragma once

#include "planner/core/message.h"
#include "planner/path/finding.h"
#include "planner/units/quantity.h"

#include <cstddef>
#include <string_view>
#include <vector>

namespace furrow {

/// An alternative that the search for the best plan tried for one of its choices.
struct TriedChoice {
    enum class Worth {
        Taken,   ///< it is part of the best plan
        Slower,  ///< than the best plan
        Behind,  ///< by more than 6 %, or it cannot be driven
    };

    std::string_view choice;             ///< see PlanChoice::id
    Message text;                        ///< "Passes: 2"
    std::vector<SettingChange> changes;  ///< an empty value is the default
    Worth worth = Worth::Behind;
    /// Saved by what was taken when it was taken, zero where it mended the plan instead; longer with what is
    /// slower; zero for what is behind.
    Duration difference;
};

/// What each choice of the best plan is worth.
struct ChoiceTable {
    Duration asked;  ///< the time of the plan as asked, with the time to work separately what it misses
    Duration best;   ///< the same of the best plan
    std::ptrdiff_t askedProblems = 0;  ///< blocking findings of the plan as asked
    std::size_t alternatives = 0;      ///< that were planned
    /// In the order of the choices; what was taken first, without what was given up again later.
    std::vector<TriedChoice> tried;
};

}  // namespace furrow
