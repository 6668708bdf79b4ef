#include "planner/route/one_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace furrow {

namespace {

// Of the last step that goes into the next one. Volgenant & Jonker 1982, doi 10.1016/0377-2217(82)90015-7.
constexpr double kMomentum = 0.3;
constexpr double kFirstStep = 1.0;
constexpr double kLeastStep = 1e-4;
// Rounds without a better bound before the step is halved.
constexpr std::size_t kPatience = 20;
constexpr double kReached = 1e-9;
constexpr std::size_t kNoLink = std::numeric_limits<std::size_t>::max();

/// The cheapest end and the cheapest one other than it.
struct TwoCheapest {
    SwathEnd first = 0;
    SwathEnd second = 0;
    double firstCost = kInfinite;
    double secondCost = kInfinite;

    void offer(SwathEnd end, double cost) {
        if (cost < firstCost) {
            second = std::exchange(first, end);
            secondCost = std::exchange(firstCost, cost);
        } else if (cost < secondCost) {
            second = end;
            secondCost = cost;
        }
    }
};

}  // namespace

OneTreeFinder::OneTreeFinder(const OneTreeTask& task)
    : task_{task}, weights_(task.links.size()), roots_(task.swathCount) {
    for (std::size_t i = 0; i < task.links.size(); ++i) {
        if (task.links[i].cost < kInfinite) {
            order_.push_back(i);
        }
    }
}

std::size_t OneTreeFinder::rootOf(std::size_t swath) {
    while (roots_[swath] != swath) {
        roots_[swath] = roots_[roots_[swath]];
        swath = roots_[swath];
    }
    return swath;
}

void OneTreeFinder::addDepot(std::span<const double> multipliers) {
    TwoCheapest in;
    TwoCheapest out;
    for (SwathEnd end = 0; end < 2 * task_.swathCount; ++end) {
        in.offer(end, task_.begin[end] + multipliers[end]);
        out.offer(end, task_.finish[end] + multipliers[end]);
    }
    tree_.first = in.first;
    tree_.last = out.first;
    double cost = in.firstCost + out.firstCost;
    if (in.first == out.first) {
        const bool moveIn = in.secondCost + out.firstCost < in.firstCost + out.secondCost;
        cost = moveIn ? in.secondCost + out.firstCost : in.firstCost + out.secondCost;
        (moveIn ? tree_.first : tree_.last) = moveIn ? in.second : out.second;
    }
    tree_.cost += cost;
    ++tree_.degrees[tree_.first];
    ++tree_.degrees[tree_.last];
}

/// Of every tree that is left, the least link to another one belongs to the least tree (Boruvka 1926). Equal
/// weights go by index, so there is one least tree, and every way to find it gives the same.
void OneTreeFinder::pickLinks() {
    std::iota(roots_.begin(), roots_.end(), std::size_t{0});
    between_ = order_;
    tree_.links.clear();
    while (tree_.links.size() + 1 < task_.swathCount) {
        least_.assign(task_.swathCount, kNoLink);
        const auto offer = [this](std::size_t root, std::size_t link) {
            if (least_[root] == kNoLink || weights_[link] < weights_[least_[root]]) {
                least_[root] = link;
            }
        };
        // Links stay in the order of their indices.
        std::size_t kept = 0;
        for (const std::size_t i : between_) {
            const std::size_t a = roots_[task_.links[i].a / 2];
            const std::size_t b = roots_[task_.links[i].b / 2];
            if (a != b) {
                between_[kept++] = i;
                offer(a, i);
                offer(b, i);
            }
        }
        between_.resize(kept);
        if (kept == 0) {
            return;
        }
        for (const std::size_t i : least_) {
            if (i == kNoLink) {
                continue;
            }
            const std::size_t a = rootOf(task_.links[i].a / 2);
            const std::size_t b = rootOf(task_.links[i].b / 2);
            if (a != b) {
                roots_[a] = b;
                tree_.links.push_back(i);
            }
        }
        for (std::size_t swath = 0; swath < task_.swathCount; ++swath) {
            roots_[swath] = rootOf(swath);
        }
    }
}

const OneTree& OneTreeFinder::find(std::span<const double> multipliers) {
    for (const std::size_t i : order_) {
        const UndirectedLink& link = task_.links[i];
        weights_[i] = link.cost + multipliers[link.a] + multipliers[link.b];
    }
    pickLinks();
    // Sums round alike wherever the tree is made.
    std::ranges::sort(tree_.links, [this](std::size_t a, std::size_t b) {
        return std::pair{weights_[a], a} < std::pair{weights_[b], b};
    });
    tree_.degrees.assign(2 * task_.swathCount, 0);
    tree_.cost = 0.0;
    for (const std::size_t i : tree_.links) {
        tree_.cost += weights_[i];
        ++tree_.degrees[task_.links[i].a];
        ++tree_.degrees[task_.links[i].b];
    }
    if (tree_.links.size() + 1 < task_.swathCount) {
        tree_.cost = kInfinite;
        return tree_;
    }
    addDepot(multipliers);
    tree_.squaredError = 0.0;
    for (std::size_t end = 0; end < tree_.degrees.size(); ++end) {
        const double error = tree_.degrees[end] - 1;
        tree_.squaredError += error * error;
        tree_.cost -= multipliers[end];
    }
    return tree_;
}

Ascent ascended(OneTreeFinder& finder, std::vector<double> multipliers, double known, std::size_t rounds,
                const JobContext& job) {
    Ascent best{.multipliers = multipliers, .tree = {}};
    std::vector<double> before(multipliers.size(), 0.0);
    double step = kFirstStep;
    std::size_t waited = 0;
    for (std::size_t round = 0; round <= rounds; ++round) {
        const OneTree& tree = finder.find(multipliers);
        if (tree.cost > best.bound) {
            best.bound = tree.cost;
            best.multipliers = multipliers;
            best.tree = tree;
            waited = 0;
        } else if (++waited >= kPatience) {
            waited = 0;
            step /= 2.0;
        }
        const bool isReached = best.bound >= known - kReached * std::abs(known);
        if (isReached || tree.isTour() || tree.cost == kInfinite || step < kLeastStep || round == rounds ||
            job.stopRequested()) {
            break;
        }
        const double length = step * (known - tree.cost) / tree.squaredError;
        for (std::size_t end = 0; end < multipliers.size(); ++end) {
            const double error = tree.degrees[end] - 1;
            const double moved = (1.0 - kMomentum) * length * error + kMomentum * before[end];
            multipliers[end] += moved;
            before[end] = moved;
        }
        job.report(static_cast<double>(round + 1) / static_cast<double>(rounds));
    }
    return best;
}

}  // namespace furrow
