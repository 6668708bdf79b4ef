#pragma once

#include "planner/path/finding.h"
#include "planner/path/fitting_ways.h"
#include "planner/path/path_builder.h"
#include "planner/plan/stages.h"
#include "planner/settings/method.h"

#include <map>
#include <optional>
#include <span>

namespace furrow {

/// Where the turns of the kind that was chosen belong: between two swaths of one cell. Other ways are
/// whatever fits, but for smooth steering, which stays smooth everywhere it can. May be asked by several
/// threads at once.
class ChosenTurns {
public:
    /// Keeps what it is made from.
    ChosenTurns(const Settings& settings, const SwathSet& swaths, const Decomposition& cells,
                const FittingWays& ways);

    /// The turn from one leg to the next of the chosen kind, where it belongs and fits.
    std::optional<Curve> between(const Leg& leaving, const Leg& arriving) const;

    /// The same from any leg to any other, as long as it leads through no obstacle: for machines that may
    /// leave the field.
    std::optional<Curve> anywhere(const Leg& leaving, const Leg& arriving) const;

    /// How many turns between swaths are of another kind, and why; nothing where all are as chosen.
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
