#pragma once

#include "planner/jobs/job.h"
#include "planner/route/link_costs.h"
#include "planner/route/one_tree.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace furrow {

/// A number that no order of these swaths costs less than, with the multipliers that prove it.
struct OrderBound {
    double cost = 0.0;
    std::vector<double> multipliers;  ///< of every end
};

/// The lower bound of Held & Karp 1970 (doi 10.1287/opre.18.6.1138) and 1971 (doi 10.1007/BF01584070) over
/// all orders and directions. Every swath is a forced edge between its ends, and a depot joins the first and
/// the last one. A least tree over the swaths relaxes the tour; multipliers of the ends are moved along the
/// subgradient with momentum. Where a link costs different amounts in both directions, the cheaper one
/// counts. Links that were never looked up count with their lower bound. Those of the best tree are checked:
/// they count with what they cost in the field. A stop request ends it with a lower bound that is valid.
///
/// @param near     links to begin with; others join them where the tree wants them
/// @param known    the cost of some order: it sets the step, and the bound never exceeds it
/// @param rounds   trees at most
/// Cost: O(links + swaths²) each round, and O(ends²) lower bounds some times.
OrderBound heldKarpBound(LinkCosts& costs, const NearEnds& near, double known, std::size_t rounds,
                         const JobContext& job);

/// The links that an order cheaper than `known` may have: a link that joins the least tree in place of the
/// dearest one between its swaths raises the bound by the difference (Jonker & Volgenant 1984, doi
/// 10.1287/opre.32.4.837). Cost: O(ends²) lower bounds, and what the links that stay cost.
std::vector<UndirectedLink> linksOfCheaperOrders(const LinkCosts& costs, const OrderBound& bound,
                                                 double known);

/// The bound of an assignment: every swath is left once for another one. It knows both directions of a link,
/// but not that the order must hang together. Cost: O(ends³). Burkard, Dell'Amico, Martello 2012, ch. 4
/// (doi 10.1137/1.9781611972238).
double assignmentBound(const LinkCosts& costs);

}  // namespace furrow
