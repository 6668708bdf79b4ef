#pragma once

#include "planner/core/result.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace furrow {

/// Work in pieces that are not interrupted, in their order, and trips to a refill point between them.
struct RefillTask {
    std::vector<double> uses;  ///< of each piece, from the tank
    double capacity = 0.0;     ///< positive
    /// What a trip before each piece costs at least, in seconds. The first is not used: the tank is fresh.
    std::vector<double> atLeast;
};

/// What trips before these pieces really cost, in seconds; empty where none is possible.
using TripCosts = std::function<Result<std::vector<std::optional<double>>>(std::span<const std::size_t>)>;

/// The pieces before which the tank is filled, rising: those whose trips cost least in all, so that no work
/// between two trips uses more than the tank holds. Where that is impossible, the least is used beyond it.
///
/// Dynamic programming over the pieces. Trips are taken to cost what they cost at least until they are part
/// of the best split; then they are asked for. After some hundred trips only those are taken that were asked
/// for. Errors: those of `costs`. Cost: a few rounds of O(pieces²), without the questions.
Result<std::vector<std::size_t>> cheapestSplit(const RefillTask& task, const TripCosts& costs);

}  // namespace furrow
