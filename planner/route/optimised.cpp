#include "planner/route/cell_sequence.h"
#include "planner/route/exact_order.h"
#include "planner/route/given_steps.h"
#include "planner/route/methods.h"
#include "planner/route/order_search.h"
#include "planner/route/patterns.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// With more swaths left out, ways get longer and turns no quicker.
constexpr std::size_t kMostSkipped = 6;
constexpr std::array<std::size_t, 3> kClusters{4, 6, 10};
constexpr std::size_t kRoundsPerSwath = 20;
constexpr std::size_t kLeastRounds = 1'000;
constexpr std::size_t kMostRounds = 4'000;
// How often an order is searched anew after ways that do not fit were found along it.
constexpr int kMostChecks = 6;

/// Patterns that are easier to follow come first.
std::vector<PatternOrder> patterns() {
    std::vector<PatternOrder> all{toAndFroOrder, snakeOrder, racetrackOrder};
    for (std::size_t skipped = 1; skipped <= kMostSkipped; ++skipped) {
        all.emplace_back([skipped](std::size_t count) { return skipOrder(count, skipped); });
    }
    for (const std::size_t cluster : kClusters) {
        all.emplace_back([cluster](std::size_t count) { return spiralOrder(count, cluster); });
    }
    return all;
}

/// The mixture of patterns by cells, then each pattern in all cells.
Result<std::vector<EndOrder>> patternOrders(const RouteTask& task, const RouteCosts& costs,
                                            const JobContext& job) {
    const std::vector<PatternOrder> all = patterns();
    std::vector<EndOrder> orders;
    for (std::size_t i = 0; i <= all.size(); ++i) {
        const auto route = i == 0 ? routeOverCells(all, task, costs, job)
                                  : routeOverCells(std::span{&all[i - 1], 1}, task, costs, job);
        if (!route) {
            return std::unexpected(route.error());
        }
        orders.push_back(endOrder(route->steps));
    }
    return orders;
}

/// Searches orders, and checks the links of each in the field, until the links of the best one are all
/// checked: no other order that was found is cheaper.
class CheckedSearch {
public:
    CheckedSearch(RouteCosts& costs, std::vector<EndOrder> starts, bool isDraft)
        : costs_{costs},
          isDraft_{isDraft},
          orders_{std::move(starts)},
          near_{nearEnds(costs.links(), kNearLinks)} {}

    EndOrder run(const JobContext& job) {
        const std::size_t swaths = costs_.links().swathCount();
        std::size_t rounds = isDraft_ ? 0 : std::clamp(kRoundsPerSwath * swaths, kLeastRounds, kMostRounds);
        for (int check = 0; check < kMostChecks && !job.stopRequested(); ++check) {
            const bool isExact = swaths <= kMostByDynamicProgramming && !isDraft_;
            orders_.push_back(
                isExact ? cheapestOrder(costs_.links()).order
                        : searchedOrder(
                              {.costs = costs_.links(), .near = near_, .starts = orders_, .rounds = rounds},
                              job.part(static_cast<double>(check) / kMostChecks, (check + 1.0) / kMostChecks))
                              .order);
            rounds /= 2;
            if (isDraft_ || !checkLinks(orders_.back())) {
                break;
            }
        }
        return cheapest(job);
    }

private:
    /// Whether something became dearer.
    bool checkLinks(const EndOrder& order) {
        bool isDearer = false;
        for (std::size_t i = 1; i < order.size(); ++i) {
            isDearer = costs_.links().check(otherEnd(order[i - 1]), order[i]) || isDearer;
        }
        return isDearer;
    }

    /// Of all orders, with their links checked where it matters. The earlier one of equals.
    EndOrder cheapest(const JobContext& job) {
        while (true) {
            const auto best = std::ranges::min_element(
                orders_, {}, [&](const EndOrder& order) { return costs_.links().of(order); });
            if (isDraft_ || job.stopRequested() || !checkLinks(*best)) {
                return *best;
            }
        }
    }

    RouteCosts& costs_;
    bool isDraft_;
    std::vector<EndOrder> orders_;
    NearEnds near_;
};

/// The order with the locked swaths at its beginning.
EndOrder lockedTogether(const EndOrder& order, EndOrder locked) {
    std::ranges::copy_if(order, std::back_inserter(locked), [named = locked](SwathEnd end) {
        return !std::ranges::contains(named, end) && !std::ranges::contains(named, otherEnd(end));
    });
    return locked;
}

Result<Route> optimised(const RouteTask& task, const JobContext& job) {
    const auto locked = givenSteps(task.settings, kLocked, task.swaths.swaths.size());
    if (!locked) {
        return std::unexpected(locked.error());
    }
    RouteCosts costs{task};
    auto starts = patternOrders(task, costs, job.withoutProgress());
    if (!starts) {
        return std::unexpected(starts.error());
    }
    if (!locked->empty()) {
        starts->push_back(lockedTogether(starts->front(), endOrder(*locked)));
    }
    const EndOrder order = CheckedSearch{costs, *std::move(starts), task.isDraft}.run(job);
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    Route route{.steps = stepsOf(order), .lengthInPlace = {}};
    route.lengthInPlace = lengthInPlace(route.steps, task.swaths);
    return route;
}

constexpr const Parameter* kParameters[] = {&kRouteObjective, &kLocked, &kCorner};

}  // namespace

const Parameter kLocked{.key = "route.locked",
                        .name = "Locked",
                        .description =
                            "Swath numbers that follow each other in this order; a minus drives one "
                            "the other way. The order of the others is searched.",
                        .kind = ParameterKind::Numbers,
                        .standard = {},
                        .choices = {}};

const Method<RoutePlanner> kOptimisedMethod{
    .info = {.id = "optimised",
             .name = "The quickest",
             .description = "Every pattern is tried and improved; the plan tells how near the order is to "
                            "the best one.",
             .parameters = kParameters},
    .run = optimised,
    .traits = {.isByTime = true}};

}  // namespace furrow
