#include "planner/route/cell_sequence.h"
#include "planner/route/earlier_order.h"
#include "planner/route/exact_order.h"
#include "planner/route/given_steps.h"
#include "planner/route/methods.h"
#include "planner/route/open_strips.h"
#include "planner/route/order_search.h"
#include "planner/route/patterns.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// With more swaths left out, ways get longer and turns no quicker.
constexpr std::size_t kMostSkipped = 6;
constexpr std::array<std::size_t, 3> kClusters{4, 6, 10};
constexpr std::size_t kRoundsPerSwath = 20;
constexpr std::size_t kLeastSearchRounds = 1'000;
constexpr std::size_t kMostSearchRounds = 4'000;
// How often an order is searched anew after ways that do not fit were found along it.
constexpr int kMostChecks = 6;
// A draft of more swaths takes the best pattern: a search takes time with the square of their number.
constexpr std::size_t kMostSearchedInDraft = 150;

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
    CheckedSearch(RouteCosts& costs, const OpenStripLimit* strips, std::vector<EndOrder> starts, bool isDraft)
        : costs_{costs}, strips_{strips}, isDraft_{isDraft}, orders_{std::move(starts)} {}

    EndOrder run(const JobContext& job) {
        const std::size_t swaths = costs_.links().swathCount();
        if (swaths > (isDraft_ ? kMostSearchedInDraft : kMostSearched)) {
            return cheapest(job);
        }
        const NearEnds near = nearEnds(costs_.links(), kNearLinks);
        std::size_t rounds =
            isDraft_ ? 0 : std::clamp(kRoundsPerSwath * swaths, kLeastSearchRounds, kMostSearchRounds);
        for (int check = 0; check < kMostChecks && !job.stopRequested(); ++check) {
            const bool isExact = swaths <= kMostByDynamicProgramming && !isDraft_ && strips_ == nullptr;
            orders_.push_back(isExact ? cheapestOrder(costs_.links()).order
                                      : searchedOrder({.costs = costs_.links(),
                                                       .near = near,
                                                       .starts = orders_,
                                                       .rounds = rounds,
                                                       .strips = strips_},
                                                      job.part(static_cast<double>(check) / kMostChecks,
                                                               (check + 1.0) / kMostChecks))
                                            .order);
            rounds /= 2;
            if (isDraft_ || !checkLinks(orders_.back(), job)) {
                break;
            }
        }
        return cheapest(job);
    }

private:
    /// Whether something became dearer.
    bool checkLinks(const EndOrder& order, const JobContext& job) {
        bool isDearer = false;
        for (std::size_t i = 1; i < order.size() && !job.stopRequested(); ++i) {
            isDearer = costs_.links().check(otherEnd(order[i - 1]), order[i]) || isDearer;
        }
        return isDearer;
    }

    /// Of all orders, with their links checked where it matters. The earlier one of equals.
    EndOrder cheapest(const JobContext& job) {
        while (true) {
            const auto best = std::ranges::min_element(orders_, {}, [&](const EndOrder& order) {
                return std::pair{strips_ != nullptr ? strips_->excess(order) : 0, costs_.links().of(order)};
            });
            if (isDraft_ || job.stopRequested() || !checkLinks(*best, job)) {
                return *best;
            }
        }
    }

    RouteCosts& costs_;
    const OpenStripLimit* strips_;
    bool isDraft_;
    std::vector<EndOrder> orders_;
};

/// The order with the locked swaths at its beginning.
EndOrder lockedTogether(const EndOrder& order, EndOrder locked) {
    std::ranges::copy_if(order, std::back_inserter(locked), [named = locked](SwathEnd end) {
        return !std::ranges::contains(named, end) && !std::ranges::contains(named, otherEnd(end));
    });
    return locked;
}

/// The locked swaths after those that lie between them, so that they need leave no strip open; then the
/// swaths to both sides, outwards.
EndOrder lockedFromInside(const EndOrder& locked, std::size_t swathCount) {
    const auto [least, most] = std::ranges::minmax(locked);
    const auto isLocked = [&](SwathEnd start) {
        return std::ranges::contains(locked, start) || std::ranges::contains(locked, otherEnd(start));
    };
    EndOrder order;
    for (SwathEnd start = least / 2 * 2; start <= most; start += 2) {
        if (!isLocked(start)) {
            order.push_back(order.size() % 2 == 0 ? start : otherEnd(start));
        }
    }
    std::ranges::copy(locked, std::back_inserter(order));
    for (SwathEnd start = least / 2 * 2; start >= 2; start -= 2) {
        order.push_back(order.size() % 2 == 0 ? start - 2 : start - 1);
    }
    for (SwathEnd start = most / 2 * 2 + 2; start < 2 * swathCount; start += 2) {
        order.push_back(order.size() % 2 == 0 ? start : otherEnd(start));
    }
    return order;
}

/// The order with the first and the last swath at its ends.
EndOrder withNamedEnds(EndOrder order, const Settings& settings) {
    const auto isNamed = [&](const Parameter& parameter) {
        return [number = settings.count(parameter)](SwathEnd end) {
            return number && end / 2 == static_cast<SwathEnd>(*number - 1);
        };
    };
    std::ranges::stable_partition(order, isNamed(kFirstSwath));
    std::ranges::stable_partition(order, std::not_fn(isNamed(kLastSwath)));
    return order;
}

/// InputRefused: a number that no swath has.
Result<void> checkNamed(const RouteTask& task) {
    const auto count = static_cast<int>(task.swaths.swaths.size());
    for (const Parameter* const parameter : {&kFirstSwath, &kLastSwath}) {
        if (const auto number = task.settings.count(*parameter); number && *number > count) {
            return std::unexpected(refused(*parameter, message("there is no swath {}", *number),
                                           message("use the numbers from 1 to {}", count)));
        }
    }
    const auto first = task.settings.count(kFirstSwath);
    if (first && first == task.settings.count(kLastSwath) && count > 1) {
        return std::unexpected(refused(kLastSwath, message("swath {} is driven first", *first),
                                       "name another swath for the end"));
    }
    return {};
}

/// The setting that an order does not follow; null where it follows all.
const Parameter* brokenSetting(const EndOrder& order, const RouteTask& task, const RouteCosts& costs,
                               const OpenStripLimit* strips) {
    if (strips != nullptr && strips->excess(order) > 0) {
        return &kOpenStrips;
    }
    if (!costs.isBroken(order)) {
        return nullptr;
    }
    return !task.settings.numbers(kLocked).empty() ? &kLocked
           : task.settings.count(kLastSwath)       ? &kLastSwath
                                                   : &kFirstSwath;
}

Route routeOf(const EndOrder& order, const SwathSet& swaths) {
    Route route{.steps = stepsOf(order), .lengthInPlace = {}};
    route.lengthInPlace = lengthInPlace(route.steps, swaths);
    return route;
}

Result<Route> optimised(const RouteTask& task, const JobContext& job) {
    const auto locked = givenSteps(task.settings, kLocked, task.swaths.swaths.size());
    if (!locked) {
        return std::unexpected(locked.error());
    }
    if (auto checked = checkNamed(task); !checked) {
        return std::unexpected(checked.error());
    }
    std::optional<OpenStripLimit> strips;
    if (const auto most = task.settings.count(kOpenStrips)) {
        strips.emplace(static_cast<std::size_t>(*most), task.cells, task.swaths.swaths.size());
    }
    const OpenStripLimit* const limit = strips ? &*strips : nullptr;
    RouteCosts costs{task};
    // That order was the quickest with ways that fit into the field, which drafts do not search. It is not
    // improved by others.
    const EndOrder earlier = orderAsBefore(task.swaths, task.earlier);
    if (!earlier.empty() && brokenSetting(earlier, task, costs, limit) == nullptr) {
        return routeOf(earlier, task.swaths);
    }
    auto starts = patternOrders(task, costs, job.withoutProgress());
    if (!starts) {
        return std::unexpected(starts.error());
    }
    if (!locked->empty()) {
        starts->push_back(lockedTogether(starts->front(), endOrder(*locked)));
        starts->push_back(lockedFromInside(endOrder(*locked), task.swaths.swaths.size()));
    }
    if (namesSwaths(task.settings)) {
        starts->push_back(withNamedEnds(starts->front(), task.settings));
    }
    const EndOrder order = CheckedSearch{costs, limit, *std::move(starts), task.isDraft}.run(job);
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    if (const Parameter* const broken = brokenSetting(order, task, costs, limit);
        broken != nullptr && !task.isDraft) {
        return std::unexpected(
            refused(*broken, "no order was found that keeps to all that is said of the order of swaths",
                    "allow more open strips, or lock fewer swaths"));
    }
    return routeOf(order, task.swaths);
}

constexpr const Parameter* kOptimisedParameters[] = {&kRouteObjective, &kFirstSwath, &kLastSwath,
                                                     &kOpenStrips,     &kLocked,     &kCorner};

// No field has more swaths.
constexpr double kMostSwaths = 1e6;

}  // namespace

const Parameter kLocked{.key = "route.locked",
                        .name = "Locked",
                        .description =
                            "Swath numbers that follow each other in this order; a minus drives one "
                            "the other way. The order of the others is searched.",
                        .kind = ParameterKind::Numbers,
                        .standard = {},
                        .choices = {}};

const Parameter kFirstSwath{.key = "route.first",
                            .name = "First swath",
                            .description = "The number of the swath that is driven first; auto takes any.",
                            .kind = ParameterKind::Count,
                            .canBeAuto = true,
                            .min = 1.0,
                            .max = kMostSwaths};

const Parameter kLastSwath{.key = "route.last",
                           .name = "Last swath",
                           .description = "The number of the swath that is driven last; auto takes any.",
                           .kind = ParameterKind::Count,
                           .canBeAuto = true,
                           .min = 1.0,
                           .max = kMostSwaths};

const Parameter kOpenStrips{
    .key = "route.open_strips",
    .name = "Open strips",
    .description =
        "Most strips that are left between driven swaths for later. With 0 the machine never comes "
        "back to a gap, so that a second one can follow; auto sets no limit.",
    .kind = ParameterKind::Count,
    .canBeAuto = true,
    .min = 0.0,
    .max = 1000.0};

bool namesSwaths(const Settings& settings) {
    return !settings.numbers(kLocked).empty() || settings.count(kFirstSwath) || settings.count(kLastSwath);
}

const Method<RoutePlanner> kOptimisedMethod{
    .info = {.id = "optimised",
             .name = "The quickest",
             .description = "Every pattern is tried and improved; the plan tells how near the order is to "
                            "the best one.",
             .parameters = kOptimisedParameters},
    .run = optimised,
    .traits = {.isByTime = true}};

}  // namespace furrow
