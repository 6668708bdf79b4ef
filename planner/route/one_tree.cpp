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
    : task_{task}, weights_(task.links.size()), firstBeside_(task.swathCount + 1, 0) {
    const auto isUsed = [](const UndirectedLink& link) { return link.cost < kInfinite; };
    for (const UndirectedLink& link : task.links) {
        if (isUsed(link)) {
            ++firstBeside_[link.a / 2 + 1];
            ++firstBeside_[link.b / 2 + 1];
        }
    }
    std::partial_sum(firstBeside_.begin(), firstBeside_.end(), firstBeside_.begin());
    beside_.resize(firstBeside_.back());
    std::vector<std::size_t> next = firstBeside_;
    for (std::size_t i = 0; i < task.links.size(); ++i) {
        const UndirectedLink& link = task.links[i];
        if (isUsed(link)) {
            beside_[next[link.a / 2]++] = {.swath = link.b / 2, .link = i};
            beside_[next[link.b / 2]++] = {.swath = link.a / 2, .link = i};
        }
    }
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

/// The tree grows by the least link to a swath that it lacks (Prim 1957). Equal weights go by index, so there
/// is one least tree, and every way to find it gives the same.
void OneTreeFinder::pickLinks() {
    tree_.links.clear();
    lacked_.resize(task_.swathCount);
    std::iota(lacked_.begin(), lacked_.end(), std::size_t{0});
    nearest_.assign(task_.swathCount, {});
    std::size_t added = lacked_.back();
    lacked_.pop_back();
    while (!lacked_.empty()) {
        nearest_[added].isIn = true;
        for (std::size_t i = firstBeside_[added]; i < firstBeside_[added + 1]; ++i) {
            Nearest& other = nearest_[beside_[i].swath];
            const double weight = weights_[beside_[i].link];
            if (!other.isIn && other.isAfter(weight, beside_[i].link)) {
                other.weight = weight;
                other.link = beside_[i].link;
            }
        }
        std::size_t least = 0;
        for (std::size_t i = 1; i < lacked_.size(); ++i) {
            const Nearest& other = nearest_[lacked_[i]];
            if (nearest_[lacked_[least]].isAfter(other.weight, other.link)) {
                least = i;
            }
        }
        added = std::exchange(lacked_[least], lacked_.back());
        lacked_.pop_back();
        if (nearest_[added].link != kNoLink) {
            tree_.links.push_back(nearest_[added].link);
        }
    }
}

const OneTree& OneTreeFinder::find(std::span<const double> multipliers) {
    for (std::size_t i = 0; i < weights_.size(); ++i) {
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
