#include "planner/route/cell_sequence.h"

#include "planner/geometry/point_grid.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace furrow {

namespace {

constexpr double kInfiniteCost = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostExact = 8;
constexpr int kMostImprovements = 4;
// A table of all links holds 8 MB at most. Improving a sequence takes time with the cube of its length: with
// 64 cells some hundredths of a second.
constexpr std::size_t kMostTabled = 1'024;
constexpr std::size_t kMostImproved = 64;
// A pattern that saves less is not worth an order that is harder to follow.
constexpr double kWorthwhile = 0.998;

/// One way to drive one cell.
struct Variant {
    std::vector<RouteStep> steps;
    double cost = 0.0;  ///< of the links
    Point begin;        ///< of its first swath
    Point end;          ///< of its last one
};

using Sequence = std::vector<std::size_t>;  ///< of cells

class CellSequencer {
public:
    CellSequencer(const LinkCosts& costs, std::vector<std::vector<Variant>> cells)
        : costs_{costs}, cells_{std::move(cells)} {
        for (const auto& variants : cells_) {
            first_.push_back(all_.size());
            for (const Variant& variant : variants) {
                all_.push_back(&variant);
            }
        }
        if (all_.size() > kMostTabled) {
            return;
        }
        links_.resize(all_.size() * all_.size());
        for (std::size_t a = 0; a < all_.size(); ++a) {
            for (std::size_t b = 0; b < all_.size(); ++b) {
                links_[a * all_.size() + b] = asked(a, b);
            }
        }
    }

    /// @param fromFirst  begin with the first variant of the first cell
    std::vector<RouteStep> best(bool fromFirst, const JobContext& job) {
        const Sequence sequence = cells_.size() <= kMostExact ? exact(fromFirst)
                                  : cells_.size() <= kMostImproved
                                      ? improved(nearest(fromFirst), fromFirst, job)
                                      : nearestInPlace();
        std::vector<RouteStep> steps;
        for (const std::size_t variant : variantsFor(sequence, fromFirst).second) {
            std::ranges::copy(all_[variant]->steps, std::back_inserter(steps));
        }
        return steps;
    }

private:
    double asked(std::size_t a, std::size_t b) const {
        return costs_.link(otherEnd(enteredEnd(all_[a]->steps.back())), enteredEnd(all_[b]->steps.front()));
    }
    double link(std::size_t a, std::size_t b) const {
        return links_.empty() ? asked(a, b) : links_[a * all_.size() + b];
    }
    std::size_t endOf(std::size_t cell) const { return first_[cell] + cells_[cell].size(); }
    std::size_t cellOf(std::size_t variant) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(first_, variant) - first_.begin()) - 1;
    }
    bool mayBegin(std::size_t variant, bool fromFirst) const { return !fromFirst || variant == first_[0]; }

    /// The best variant of each cell in this sequence (Viterbi), and the whole cost.
    std::pair<double, std::vector<std::size_t>> variantsFor(const Sequence& sequence, bool fromFirst) const {
        std::vector<double> cost(all_.size(), kInfiniteCost);
        std::vector<std::size_t> before(all_.size(), 0);
        for (std::size_t v = first_[sequence.front()]; v < endOf(sequence.front()); ++v) {
            cost[v] = mayBegin(v, fromFirst) ? all_[v]->cost : kInfiniteCost;
        }
        for (std::size_t i = 1; i < sequence.size(); ++i) {
            for (std::size_t v = first_[sequence[i]]; v < endOf(sequence[i]); ++v) {
                for (std::size_t u = first_[sequence[i - 1]]; u < endOf(sequence[i - 1]); ++u) {
                    if (const double total = cost[u] + link(u, v) + all_[v]->cost; total < cost[v]) {
                        cost[v] = total;
                        before[v] = u;
                    }
                }
            }
        }
        const std::size_t last = sequence.back();
        std::size_t best = first_[last];
        for (std::size_t v = first_[last]; v < endOf(last); ++v) {
            best = cost[v] < cost[best] ? v : best;
        }
        std::vector<std::size_t> chosen{best};
        for (std::size_t i = sequence.size(); i-- > 1;) {
            chosen.push_back(before[chosen.back()]);
        }
        std::ranges::reverse(chosen);
        return {cost[best], std::move(chosen)};
    }

    /// Held & Karp 1962, doi 10.1137/0110015, over cells and variants.
    Sequence exact(bool fromFirst) const {
        const std::size_t count = cells_.size();
        const std::size_t sets = std::size_t{1} << count;
        std::vector<double> cost(sets * all_.size(), kInfiniteCost);
        std::vector<std::size_t> before(sets * all_.size(), all_.size());
        for (std::size_t v = 0; v < all_.size(); ++v) {
            if (mayBegin(v, fromFirst)) {
                cost[(std::size_t{1} << cellOf(v)) * all_.size() + v] = all_[v]->cost;
            }
        }
        for (std::size_t set = 1; set < sets; ++set) {
            for (std::size_t u = 0; u < all_.size(); ++u) {
                const double here = cost[set * all_.size() + u];
                if (here == kInfiniteCost) {
                    continue;
                }
                for (std::size_t v = 0; v < all_.size(); ++v) {
                    const std::size_t bit = std::size_t{1} << cellOf(v);
                    const std::size_t next = (set | bit) * all_.size() + v;
                    if ((set & bit) == 0 && here + link(u, v) + all_[v]->cost < cost[next]) {
                        cost[next] = here + link(u, v) + all_[v]->cost;
                        before[next] = u;
                    }
                }
            }
        }
        std::size_t set = sets - 1;
        std::size_t at = 0;
        for (std::size_t v = 0; v < all_.size(); ++v) {
            at = cost[set * all_.size() + v] < cost[set * all_.size() + at] ? v : at;
        }
        Sequence sequence;
        while (at != all_.size()) {
            sequence.push_back(cellOf(at));
            const std::size_t previous = before[set * all_.size() + at];
            set &= ~(std::size_t{1} << cellOf(at));
            at = previous;
        }
        std::ranges::reverse(sequence);
        return sequence;
    }

    Sequence nearest(bool fromFirst) const {
        Sequence best;
        double leastOfAll = kInfiniteCost;
        for (std::size_t start = 0; start < (fromFirst ? 1 : cells_.size()); ++start) {
            Sequence sequence{start};
            std::vector<bool> done(cells_.size(), false);
            done[start] = true;
            std::size_t at = first_[start];
            while (sequence.size() < cells_.size()) {
                std::size_t next = all_.size();
                for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
                    for (std::size_t v = first_[cell]; !done[cell] && v < endOf(cell); ++v) {
                        next = next == all_.size() || link(at, v) < link(at, next) ? v : next;
                    }
                }
                const std::size_t cell = cellOf(next);
                done[cell] = true;
                sequence.push_back(cell);
                at = next;
            }
            if (const double cost = variantsFor(sequence, fromFirst).first; cost < leastOfAll) {
                leastOfAll = cost;
                best = std::move(sequence);
            }
        }
        return best;
    }

    /// From the first cell always on to the one that begins nearest to where this one ends, by straight
    /// distance.
    Sequence nearestInPlace() const {
        std::vector<Point> begins;
        for (const Variant* variant : all_) {
            begins.push_back(variant->begin);
        }
        PointGrid open{std::move(begins)};
        Sequence sequence;
        std::size_t at = first_.front();
        while (true) {
            const std::size_t cell = cellOf(at);
            sequence.push_back(cell);
            for (std::size_t v = first_[cell]; v < endOf(cell); ++v) {
                open.takeOut(v);
            }
            const auto next = open.nearest(all_[at]->end);
            if (!next) {
                return sequence;
            }
            at = *next;
        }
    }

    /// 2-opt.
    Sequence improved(Sequence sequence, bool fromFirst, const JobContext& job) const {
        double cost = variantsFor(sequence, fromFirst).first;
        for (int round = 0; round < kMostImprovements; ++round) {
            bool better = false;
            for (std::size_t i = fromFirst ? 1 : 0; i + 1 < sequence.size(); ++i) {
                for (std::size_t k = i + 1; k < sequence.size() && !job.stopRequested(); ++k) {
                    Sequence turned = sequence;
                    std::reverse(turned.begin() + static_cast<std::ptrdiff_t>(i),
                                 turned.begin() + static_cast<std::ptrdiff_t>(k) + 1);
                    if (const double other = variantsFor(turned, fromFirst).first; other < cost - 1e-6) {
                        cost = other;
                        sequence = std::move(turned);
                        better = true;
                    }
                }
            }
            if (!better) {
                break;
            }
        }
        return sequence;
    }

    const LinkCosts& costs_;
    std::vector<std::vector<Variant>> cells_;
    std::vector<const Variant*> all_;
    std::vector<std::size_t> first_;  ///< variant of each cell
    std::vector<double> links_;       ///< between all variants; empty where there are too many
};

std::vector<Variant> variantsIn(const std::vector<std::size_t>& cell, const PatternOrder& order,
                                const RouteTask& task, const RouteCosts& costs) {
    SwathSet part;
    for (const std::size_t swath : cell) {
        part.swaths.push_back(task.swaths.swaths[swath]);
    }
    std::vector<Variant> variants;
    for (std::vector<RouteStep>& steps : variantsOf(order(trackCount(part)), part, task.settings)) {
        for (RouteStep& step : steps) {
            step.swath = cell[step.swath];
        }
        const double cost = costs.links().between(endOrder(steps));
        const Point begin = startPose(steps.front(), task.swaths).position;
        const Point end = endPose(steps.back(), task.swaths).position;
        variants.push_back({.steps = std::move(steps), .cost = cost, .begin = begin, .end = end});
    }
    return variants;
}

/// The cost including the work, as a base for the share that a pattern saves.
double leastCost(const std::vector<Variant>& variants, const RouteCosts& costs) {
    double working = 0.0;
    for (const RouteStep& step : variants.front().steps) {
        working += costs.workingOn(step.swath);
    }
    return working + std::ranges::min_element(variants, {}, &Variant::cost)->cost;
}

/// The variants of the quickest pattern in this cell. Of about equal ones the first.
std::vector<Variant> quickestVariants(const std::vector<std::size_t>& cell,
                                      std::span<const PatternOrder> patterns, const RouteTask& task,
                                      const RouteCosts& costs) {
    std::vector<Variant> best = variantsIn(cell, patterns.front(), task, costs);
    double bestCost = leastCost(best, costs);
    for (const PatternOrder& pattern : patterns.subspan(1)) {
        std::vector<Variant> other = variantsIn(cell, pattern, task, costs);
        if (const double cost = leastCost(other, costs); cost < kWorthwhile * bestCost) {
            best = std::move(other);
            bestCost = cost;
        }
    }
    return best;
}

}  // namespace

Result<Route> routeOverCells(const PatternOrder& order, const RouteTask& task, const JobContext& job) {
    return routeOverCells(std::span{&order, 1}, task, RouteCosts{task}, job);
}

Result<Route> routeOverCells(std::span<const PatternOrder> patterns, const RouteTask& task,
                             const RouteCosts& costs, const JobContext& job) {
    std::vector<std::vector<Variant>> cells;
    for (const std::vector<std::size_t>& cell : task.cells) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (!cell.empty()) {
            cells.push_back(quickestVariants(cell, patterns, task, costs));
        }
    }
    if (cells.size() <= 1 && patterns.size() == 1) {
        return bestRoute(patterns.front()(trackCount(task.swaths)), task, costs, job);
    }
    if (cells.empty()) {
        std::vector<std::size_t> all(task.swaths.swaths.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        cells.push_back(quickestVariants(all, patterns, task, costs));
    }
    if (cells.size() == 1) {
        Route route{.steps = std::ranges::min_element(cells.front(), {}, &Variant::cost)->steps,
                    .lengthInPlace = {}};
        route.lengthInPlace = lengthInPlace(route.steps, task.swaths);
        return route;
    }
    const bool fromFirst = cells.front().size() == 1;
    Route route{.steps = CellSequencer{costs.links(), std::move(cells)}.best(fromFirst, job),
                .lengthInPlace = {}};
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    route.lengthInPlace = lengthInPlace(route.steps, task.swaths);
    return route;
}

}  // namespace furrow
