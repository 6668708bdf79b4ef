#include "planner/route/link_costs.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace furrow {

namespace {

// 32 MB.
constexpr std::size_t kMostEntries = std::size_t{1} << 21;
constexpr int kKeyBits = 64;

struct NearEnd {
    double cost = 0.0;
    SwathEnd end = 0;

    auto operator<=>(const NearEnd&) const = default;
};

/// The cheapest ends by `cost`, without asking for those that `atLeast` rules out.
template <class Cost, class AtLeast>
std::vector<SwathEnd> cheapest(SwathEnd from, std::size_t endCount, std::size_t count, const Cost& cost,
                               const AtLeast& atLeast) {
    std::vector<NearEnd> open;
    open.reserve(endCount);
    for (SwathEnd end = 0; end < endCount; ++end) {
        if (end / 2 != from / 2) {
            open.push_back({atLeast(end), end});
        }
    }
    std::ranges::make_heap(open, std::ranges::greater{});
    std::vector<NearEnd> found;
    while (!open.empty() && (found.size() < count || open.front().cost < found.back().cost)) {
        const SwathEnd end = open.front().end;
        std::ranges::pop_heap(open, std::ranges::greater{});
        open.pop_back();
        const NearEnd near{cost(end), end};
        found.insert(std::ranges::upper_bound(found, near), near);
        if (found.size() > count) {
            found.pop_back();
        }
    }
    std::vector<SwathEnd> ends(found.size());
    std::ranges::transform(found, ends.begin(), &NearEnd::end);
    return ends;
}

}  // namespace

EndOrder endOrder(const std::vector<RouteStep>& steps) {
    EndOrder order(steps.size());
    std::ranges::transform(steps, order.begin(), enteredEnd);
    return order;
}

std::vector<RouteStep> stepsOf(const EndOrder& order) {
    std::vector<RouteStep> steps(order.size());
    std::ranges::transform(order, steps.begin(), stepEntering);
    return steps;
}

LinkCosts::LinkCosts(std::size_t swathCount, Functions functions)
    : swathCount_{swathCount},
      functions_{std::move(functions)},
      isWhole_{endCount() * endCount() <= kMostEntries},
      shift_{kKeyBits - std::countr_zero(kMostEntries)},
      table_(isWhole_ ? std::max<std::size_t>(1, endCount() * endCount()) : kMostEntries) {}

bool LinkCosts::check(SwathEnd leaving, SwathEnd entered) {
    const std::uint64_t key = keyOf(leaving, entered);
    if (!functions_.fitting || checked_.contains(key)) {
        return false;
    }
    const double free = functions_.link(leaving, entered);
    const double cost = std::max(free, functions_.fitting(leaving, entered).value_or(free));
    checked_.emplace(key, cost);
    table_[slotOf(key)] = {key, cost};
    return cost > free;
}

double LinkCosts::eitherWay(SwathEnd a, SwathEnd b) const {
    return std::min(link(a, b), link(b, a));
}

double LinkCosts::atLeast(SwathEnd a, SwathEnd b) const {
    if (!functions_.atLeast || (isKnown(a, b) && isKnown(b, a))) {
        return eitherWay(a, b);
    }
    return functions_.atLeast(a, b);
}

double LinkCosts::between(const EndOrder& order) const {
    double sum = 0.0;
    for (std::size_t i = 1; i < order.size(); ++i) {
        sum += link(otherEnd(order[i - 1]), order[i]);
    }
    return sum;
}

double LinkCosts::of(const EndOrder& order) const {
    if (order.empty()) {
        return 0.0;
    }
    return begin(order.front()) + between(order) + finish(otherEnd(order.back()));
}

NearEnds nearEnds(const LinkCosts& costs, std::size_t count) {
    NearEnds near;
    const auto ends = static_cast<SwathEnd>(costs.endCount());
    for (SwathEnd end = 0; end < ends; ++end) {
        const auto atLeast = [&](SwathEnd other) { return costs.atLeast(end, other); };
        near.enteredFrom.push_back(
            cheapest(end, ends, count, [&](SwathEnd other) { return costs.link(end, other); }, atLeast));
        near.leftBefore.push_back(
            cheapest(end, ends, count, [&](SwathEnd other) { return costs.link(other, end); }, atLeast));
    }
    return near;
}

}  // namespace furrow
