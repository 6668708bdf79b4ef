#pragma once

#include "planner/route/route.h"
#include "planner/route/route_costs.h"

#include <cstddef>
#include <vector>

namespace furrow {

/// An order of the tracks 0 to count - 1, each once.
using TrackOrder = std::vector<std::size_t>;

/// 0, 1, 2 ...
TrackOrder toAndFroOrder(std::size_t count);
/// Every second one out, the rest back: 0, 2, 4, 5, 3, 1 (the paper's snake).
TrackOrder snakeOrder(std::size_t count);
/// A snake within each cluster of `cluster` tracks, one cluster after the other (the paper's spiral).
TrackOrder spiralOrder(std::size_t count, std::size_t cluster);
/// Leaves out `skip` tracks on the way out and one less on the way back, so that all turns have about the
/// same width: 0, 2, 1, 3, 5, 4 for one.
TrackOrder skipOrder(std::size_t count, std::size_t skip);
/// Round and round with half of the tracks in between: 0, 3, 1, 4, 2, 5.
TrackOrder racetrackOrder(std::size_t count);

/// Drives the tracks in this order, each in the opposite direction to the one before. The pieces of one track
/// follow each other.
std::vector<RouteStep> alongTracks(const SwathSet& swaths, const TrackOrder& order, bool firstReversed);

/// The ways to drive tracks in this order. With route.corner `best`, eight: all four start corners and both
/// directions through the order. With `first`, the one from the start of the first swath.
std::vector<std::vector<RouteStep>> variantsOf(const TrackOrder& order, const SwathSet& swaths,
                                               const Settings& settings);

/// The route in this order of tracks. With route.corner `best`, the one of all four start corners and both
/// directions through the order that costs least. With `first`, from the start of the first swath. Cancelled.
/// Cost: eight times the turns.
Result<Route> bestRoute(const TrackOrder& order, const RouteTask& task, const RouteCosts& costs,
                        const JobContext& job);

/// The number of tracks that the swaths were cut from.
std::size_t trackCount(const SwathSet& swaths);

}  // namespace furrow
