#pragma once

#include "planner/settings/method.h"
#include "planner/turns/manoeuvre_search.h"
#include "planner/turns/turn_method.h"

#include <optional>

namespace furrow {

/// In free space the quickest of all turns; in a field, by feasibleConnection, the quickest that fits.
extern const Method<TurnPlanner> kBestFeasibleMethod;

/// The way from where one working stretch ends to where the next begins that stays inside: the quickest turn of any
/// type whose swept shape does, or else a searched way of several moves. Where there is none either, the quickest
/// turn of free space, which leaves the field.
/// @param travel  what it costs to drive where; empty: the same everywhere
/// Cost: some ten microseconds where a turn fits, up to half a second where nothing does.
Turn feasibleConnection(const Rig& rig, const Pose& leaving, const Pose& arriving, const TravelCost& travel,
                        const JobContext& job);
/// The same; nothing where nothing fits.
std::optional<Turn> fittingConnection(const Rig& rig, const Pose& leaving, const Pose& arriving, const TravelCost& travel,
                                      const JobContext& job, SearchEffort effort = SearchEffort::Thorough);

/// The turn of one kind, where it stays inside and leads over nothing dear that it could go round. Nothing where it does
/// not, and where the poses or the machine do not allow this kind.
std::optional<Turn> fittingTurn(const Rig& rig, const Pose& leaving, const Pose& arriving, const TravelCost& travel,
                                const Method<TurnPlanner>& kind);

}  // namespace furrow
