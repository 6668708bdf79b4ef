#include "planner/route/cell_sequence.h"
#include "planner/route/methods.h"
#include "planner/route/patterns.h"

#include <array>
#include <vector>

namespace furrow {

namespace {

// With more swaths left out, ways get longer and turns no quicker.
constexpr std::size_t kMostSkipped = 6;
constexpr std::array<std::size_t, 3> kClusters{4, 6, 10};
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

Result<Route> optimised(const RouteTask& task, const JobContext& job) {
    return routeOverCells(patterns(), task, job);
}

constexpr const Parameter* kParameters[] = {&kCorner};

}  // namespace

const Method<RoutePlanner> kOptimisedMethod{
    .info = {.id = "optimised",
             .name = "The quickest",
             .description = "Of all patterns the one with the quickest turns for this machine.",
             .parameters = kParameters},
    .run = optimised,
    .traits = {.isByTime = true}};

}  // namespace furrow
