#include "planner/path/refill_split.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace furrow {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Work that uses more than the tank holds is worse than any trip, s for a whole tank.
constexpr double kBeyond = 1e9;
// Rounding of sums.
constexpr double kNoMore = 1e-9;
constexpr std::size_t kMostAsked = 240;

/// The best split by these costs of trips.
std::vector<std::size_t> splitBy(const RefillTask& task, const std::vector<double>& cost) {
    const std::size_t count = task.uses.size();
    // Of the work before a piece, if a trip leads there.
    std::vector<double> best(count + 1, kNever);
    std::vector<std::size_t> from(count + 1, 0);
    best[0] = 0.0;
    for (std::size_t begin = 0; begin < count; ++begin) {
        if (best[begin] == kNever) {
            continue;
        }
        double used = 0.0;
        for (std::size_t end = begin + 1; end <= count; ++end) {
            used += task.uses[end - 1];
            const double beyond = used / task.capacity - 1.0;
            const double trip = end < count ? cost[end] : 0.0;
            const double all = best[begin] + trip + (beyond > kNoMore ? kBeyond * beyond : 0.0);
            if (all < best[end]) {
                best[end] = all;
                from[end] = begin;
            }
        }
    }
    std::vector<std::size_t> before;
    for (std::size_t at = from[count]; at > 0; at = from[at]) {
        before.push_back(at);
    }
    std::ranges::reverse(before);
    return before;
}

}  // namespace

Result<std::vector<std::size_t>> cheapestSplit(const RefillTask& task, const TripCosts& costs) {
    std::vector<double> cost = task.atLeast;
    std::vector<bool> isKnown(cost.size(), false);
    for (std::size_t asked = 0;;) {
        std::vector<std::size_t> split = splitBy(task, cost);
        std::vector<std::size_t> unknown;
        std::ranges::copy_if(split, std::back_inserter(unknown), [&](std::size_t i) { return !isKnown[i]; });
        if (unknown.empty()) {
            return split;
        }
        const auto real = costs(unknown);
        if (!real) {
            return std::unexpected(real.error());
        }
        for (std::size_t i = 0; i < unknown.size(); ++i) {
            cost[unknown[i]] = (*real)[i].value_or(kNever);
            isKnown[unknown[i]] = true;
        }
        asked += unknown.size();
        if (asked >= kMostAsked) {
            for (std::size_t i = 0; i < cost.size(); ++i) {
                cost[i] = isKnown[i] ? cost[i] : kNever;
            }
        }
    }
}

}  // namespace furrow
