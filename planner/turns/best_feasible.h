#pragma once

#include "planner/settings/method.h"
#include "planner/turns/manoeuvre_search.h"
#include "planner/turns/straight_ways.h"
#include "planner/turns/turn_method.h"

#include <optional>

namespace furrow {

/// In free space the quickest of all turns. In a field, by feasibleConnection, the quickest that fits.
extern const Method<TurnPlanner> kBestFeasibleMethod;

/// The way from the end of one working stretch to the start of the next that stays inside. It is the quickest
/// turn of any type whose swept shape stays inside, or else a searched way of several moves. If there is
/// none, it is the quickest turn of free space, which leaves the field.
/// @param travel  cost of driving at a place; empty: the same everywhere
/// Cost: some ten microseconds if a turn fits, up to half a second if nothing does.
Curve feasibleConnection(const Rig& rig, const Pose& leaving, const Pose& arriving, const TravelCost& travel,
                         const JobContext& job);
/// The same. Empty if nothing fits.
/// @param straights  of this area, for machines that turn on the spot; may be null
/// @param apart      see searchManoeuvre
std::optional<Curve> fittingConnection(const Rig& rig, const Pose& leaving, const Pose& arriving,
                                       const TravelCost& travel, const JobContext& job,
                                       SearchEffort effort = SearchEffort::Thorough,
                                       const StraightWays* straights = nullptr, const Apart& apart = {});

/// The turn of one kind, if it stays inside and does not cross dear places that it could go round. Empty if
/// it does not fit, or if the poses or the machine do not allow this kind.
std::optional<Curve> fittingTurn(const Rig& rig, const Pose& leaving, const Pose& arriving,
                                 const TravelCost& travel, const Method<TurnPlanner>& kind);

}  // namespace furrow
