#include "planner/route/route_proof.h"

#include "planner/route/exact_order.h"
#include "planner/route/order_bound.h"
#include "planner/route/order_search.h"
#include "planner/route/route_costs.h"

#include <algorithm>

namespace furrow {

namespace {

// Of the multipliers: fewer for many swaths, about two seconds at most.
constexpr std::size_t kMostAscentRounds = 1'500;
constexpr std::size_t kLeastAscentRounds = 200;
constexpr std::size_t kRoundsTimesSwaths = 200'000;
constexpr std::size_t kMostByBranching = 36;
// Nodes of branch and bound times the square of the number of swaths: some tenths of a second.
constexpr std::size_t kBranchingWork = 150'000;
// An assignment takes time with the third power of the number.
constexpr std::size_t kMostAssigned = 200;
// A smaller gap is none.
constexpr double kProved = 1e-6;
// Shares of the progress: the links of the order, and the bound from multipliers.
constexpr double kChecked = 0.2;
constexpr double kBounded = 0.8;

double share(double cost, double bound) {
    return cost > bound && bound > 0.0 ? cost / bound - 1.0 : 0.0;
}

}  // namespace

double RouteProof::gap() const {
    return share(nonWorking, lowerBound);
}

double RouteProof::gapTotal() const {
    return share(working + nonWorking, working + lowerBound);
}

bool RouteProof::isBest() const {
    // A smaller gap is shown as 0.0 %.
    constexpr double kRounding = 0.0005;
    return gap() < kRounding;
}

Result<std::optional<RouteProof>> proofOf(const Route& route, const RouteTask& task, const JobContext& job) {
    RouteCosts costs{task};
    LinkCosts& links = costs.links();
    const EndOrder order = endOrder(route.steps);
    if (order.size() > kMostSearched) {
        return std::nullopt;
    }
    for (std::size_t i = 1; i < order.size(); ++i) {
        if (task.way && !task.way(route.steps[i - 1], route.steps[i], SearchEffort::Thorough)) {
            return std::nullopt;
        }
        links.check(otherEnd(order[i - 1]), order[i]);
        job.report(kChecked * static_cast<double>(i) / static_cast<double>(order.size()));
    }
    RouteProof proof{.working = costs.working(), .nonWorking = links.of(order), .lowerBound = 0.0};
    costs.setEffort(SearchEffort::None);
    const std::size_t swaths = links.swathCount();
    const std::size_t rounds = std::clamp(kRoundsTimesSwaths / std::max<std::size_t>(1, swaths),
                                          kLeastAscentRounds, kMostAscentRounds);
    const FoundOrder known{.order = order, .cost = proof.nonWorking};
    const OrderBound bound =
        heldKarpBound(links, nearEnds(links, kNearLinks), known.cost, rounds, job.part(kChecked, kBounded));
    proof.lowerBound = bound.cost;
    if (proof.gap() > kProved && swaths <= kMostByDynamicProgramming) {
        proof.lowerBound = std::min(known.cost, cheapestOrder(links).cost);
    } else if (proof.gap() > kProved && swaths <= kMostByBranching) {
        proof.lowerBound =
            branchAndBound(links, known, bound, kBranchingWork / (swaths * swaths), job.withoutProgress())
                .bound;
    }
    if (proof.gap() > kProved && swaths <= kMostAssigned) {
        proof.lowerBound = std::max(proof.lowerBound, std::min(known.cost, assignmentBound(links)));
    }
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    return proof;
}

}  // namespace furrow
