#pragma once

#include "planner/route/patterns.h"

#include <functional>
#include <span>

namespace furrow {

/// The order in which a pattern drives a given number of tracks.
using PatternOrder = std::function<TrackOrder(std::size_t)>;

/// Drives every cell by the pattern, one cell after the other. The sequence of the cells and their starting
/// corners give the least cost of turns and of ways between cells, in free space. Exact for up to eight
/// cells. For up to 64, the nearest next one, improved by reversing stretches of the sequence. For more, from
/// the first cell the one that begins nearest by straight distance. With route.corner `first`, starts at the
/// start of the first swath. Cancelled. Cost: eight times the turns, and 64 ways for each pair of up to 64
/// cells, or of cells that follow each other; memory of 8 MB at most.
Result<Route> routeOverCells(const PatternOrder& order, const RouteTask& task, const JobContext& job);

/// The same with, in each cell, the pattern that costs least there in free space. A pattern that saves less
/// than 0.2 % of the cell's cost is passed over for an earlier one. Cost: each pattern's turns, then that of
/// one pattern.
Result<Route> routeOverCells(std::span<const PatternOrder> patterns, const RouteTask& task,
                             const RouteCosts& costs, const JobContext& job);

}  // namespace furrow
