#pragma once

#include "planner/jobs/job.h"
#include "planner/route/order_bound.h"
#include "planner/route/order_search.h"

#include <cstddef>

namespace furrow {

/// With more swaths, dynamic programming takes too much memory.
inline constexpr std::size_t kMostByDynamicProgramming = 12;

/// The cheapest order of all. For at most `kMostByDynamicProgramming` swaths. Source: Held & Karp 1962, doi
/// 10.1137/0110015, over ends. Cost: O(2^swaths swaths²): a tenth of a second for twelve.
FoundOrder cheapestOrder(const LinkCosts& costs);

/// An order and a bound for all orders. Equal if the order is proved to be the cheapest.
struct ProvedOrder {
    FoundOrder found;
    double bound = 0.0;
};

/// Branch and bound with one-trees: a link of an end that has several is taken or forbidden. Starts from a
/// known order and the multipliers of its bound. After `mostNodes` or a stop request, the bound is that of
/// the nodes left. Source: Held & Karp 1971, doi 10.1007/BF01584070. Cost: some ten trees over all links for
/// each node.
ProvedOrder branchAndBound(const LinkCosts& costs, const FoundOrder& known, const OrderBound& bound,
                           std::size_t mostNodes, const JobContext& job);

}  // namespace furrow
