#pragma once

#include "planner/route/route.h"

#include <cstddef>
#include <string>
#include <vector>

namespace furrow {

/// The order with the step at `from` at the place `to`, places from 0; the others close up. Directions follow
/// the new order, so that the straight ways from swath to swath are the shortest: those of closed swaths
/// stay. Cost: O(steps).
std::vector<RouteStep> withStepMoved(const std::vector<RouteStep>& steps, std::size_t from, std::size_t to,
                                     const SwathSet& swaths);

/// The order with one step driven the other way; a closed swath stays as it is.
std::vector<RouteStep> withStepTurned(std::vector<RouteStep> steps, std::size_t at, const SwathSet& swaths);

/// As route.order and route.locked have it: "3,-1,2".
std::string orderText(const std::vector<RouteStep>& steps);

}  // namespace furrow
