#pragma once

#include "planner/jobs/job.h"
#include "planner/turns/rig.h"
#include "planner/turns/travel_cost.h"

#include <functional>
#include <optional>
#include <string_view>

namespace furrow {

/// The type of a searched turn.
inline constexpr std::string_view kCombinedTurn = "combined";

/// Effort of the search for a way that may not exist. Most ways are found within a few hundred moves. None:
/// no search if no single curve fits.
enum class SearchEffort { Thorough, Quick, None };

/// Whether it is known that no way leads from one pose to another. Asked only where a search would take long;
/// empty: never known.
using Apart = std::function<bool(const Pose& from, const Pose& to)>;

/// A drivable way between two poses if no single turn fits: round obstacles and corners, in several moves.
///
/// Hybrid A* (Dolgov, Thrun, Montemerlo & Diebel 2010, doi 10.1177/0278364909359210) with arcs of the
/// smallest radius and straights, forwards and, if the machine can, in reverse. Each move is checked with the
/// rig's swept shape. The last stretch is a Dubins or Reeds-Shepp curve that ends exactly at the goal. Two
/// estimates guide the search: the way through a grid of places with room for the tractor, and the curve of
/// free space.
///
/// @param travel  empty: every place costs the same
/// @return a turn of type kCombinedTurn, near the shortest. Empty if none was found within some thousand
/// moves, or if the job was stopped.
/// Cost: a tenth of a millisecond for each tested move; from milliseconds to half a second.
std::optional<Curve> searchManoeuvre(const Rig& rig, const Pose& from, const Pose& to,
                                     const TravelCost& travel, const JobContext& job,
                                     SearchEffort effort = SearchEffort::Thorough, const Apart& apart = {});

}  // namespace furrow
