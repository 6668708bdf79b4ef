#pragma once

#include "planner/jobs/job.h"
#include "planner/turns/rig.h"
#include "planner/turns/travel_cost.h"

#include <optional>
#include <string_view>

namespace furrow {

/// The type of a searched turn.
inline constexpr std::string_view kCombinedTurn = "combined";

/// How long is looked for a way that may not exist: most are found within a few hundred moves. None: where no single
/// curve fits there is none.
enum class SearchEffort { Thorough, Quick, None };

/// A drivable way between two poses where no single turn fits: round obstacles and corners, in several moves.
///
/// Hybrid A* (Dolgov, Thrun, Montemerlo & Diebel 2010, doi 10.1177/0278364909359210): arcs of the smallest radius
/// and straights, forwards and in reverse where the machine can, each checked with the rig's swept shape; the last
/// stretch is a Dubins or Reeds-Shepp curve that ends exactly at the goal. It is guided by the way through a grid on
/// which the tractor finds room, and by the curve that free space would allow.
///
/// @param travel  empty: every place costs the same
/// @return a turn of type kCombinedTurn, not the shortest but near it. Nothing where none was found within some
///         thousand moves, or the job was stopped.
/// Cost: a tenth of a millisecond for each move that is looked at; from milliseconds to half a second.
std::optional<Turn> searchManoeuvre(const Rig& rig, const Pose& from, const Pose& to, const TravelCost& travel,
                                    const JobContext& job, SearchEffort effort = SearchEffort::Thorough);

}  // namespace furrow
