#pragma once

#include "planner/route/patterns.h"

#include <functional>
#include <span>

namespace furrow {

/// The order in which a pattern drives so many tracks.
using PatternOrder = std::function<TrackOrder(std::size_t)>;

/// Every cell by the pattern, one cell after the other: which after which, and from which corner each, so that turns
/// and the ways between cells, in free space, take least time. Exact for up to eight cells; for more the nearest
/// next one, improved by turning stretches of the sequence round. With route.corner `first` from the start of the
/// first swath. Cancelled. Cost: eight times the turns, and 64 ways for each pair of cells.
Result<Route> routeOverCells(const PatternOrder& order, const RouteTask& task, const JobContext& job);

/// The same with, in each cell, the pattern that is quickest there in free space; one that saves less than 0.2 % of the
/// cell's time is passed over for one before it. Cost: that of each pattern's turns, then of one pattern.
Result<Route> routeOverCells(std::span<const PatternOrder> patterns, const RouteTask& task, const JobContext& job);

}  // namespace furrow
