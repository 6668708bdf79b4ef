#pragma once

#include "planner/path/finding.h"
#include "planner/path/fitting_ways.h"
#include "planner/path/path_builder.h"
#include "planner/plan/stages.h"
#include "planner/settings/method.h"

#include <map>
#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// The swaths of each cell. Empty where any kind of turn may be taken: then cells make no difference to
/// turns.
std::vector<std::vector<std::size_t>> turnCells(const Settings& settings, const Decomposition& cells);

/// Turns of the chosen kind. They belong between two swaths of one cell. Other ways take any kind that fits;
/// a kind with continuous curvature is also used there if it fits. Thread-safe.
class ChosenTurns {
public:
    /// Keeps references to all parameters.
    ChosenTurns(const Settings& settings, const SwathSet& swaths, const Decomposition& cells,
                const FittingWays& ways);

    /// The turn of the chosen kind from one leg to the next. Empty if it does not belong there or does not
    /// fit.
    std::optional<Curve> between(const Leg& leaving, const Leg& arriving) const;

    /// The same between any two legs, if it leads through no obstacle: for machines that may leave the field.
    std::optional<Curve> anywhere(const Leg& leaving, const Leg& arriving) const;

    /// The number of turns between swaths that are of another kind, and the reason. Empty if there are none.
    std::optional<Finding> told(std::span<const Leg> legs) const;

private:
    bool belongsBetween(const Leg& leaving, const Leg& arriving) const;
    std::optional<Curve> fitting(const Method<TurnPlanner>& kind, const Leg& leaving,
                                 const Leg& arriving) const;

    const Method<TurnPlanner>& kind_;
    const FittingWays& ways_;
    std::map<int, std::size_t> cellOfSwath_;  ///< by its number
};

}  // namespace furrow
