#include "planner/route/exact_order.h"

#include "planner/route/one_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// Less is rounding, in parts of the whole cost.
constexpr double kBoundRounding = 1e-9;
// Steps of the multipliers in a node; those of its parent are near.
constexpr std::size_t kRoundsInNode = 60;

/// A part of all orders: some links are taken, some are forbidden.
struct Node {
    double bound = -kInfinite;
    std::vector<double> multipliers;
    std::vector<std::size_t> taken;  ///< by index of the link
    std::vector<std::size_t> forbidden;
};

struct HeapOrder {
    bool operator()(const Node& a, const Node& b) const { return a.bound > b.bound; }
};

class BranchAndBound {
public:
    BranchAndBound(const LinkCosts& costs, const FoundOrder& known, const OrderBound& bound)
        : costs_{costs},
          best_{known},
          bound_{bound},
          links_{linksOfCheaperOrders(costs, bound, known.cost)},
          begin_(costs.endCount()),
          finish_(costs.endCount()) {
        for (SwathEnd end = 0; end < costs.endCount(); ++end) {
            begin_[end] = costs.begin(end);
            finish_[end] = costs.finish(end);
        }
    }

    ProvedOrder run(std::size_t mostNodes, const JobContext& job);

private:
    double closedAt() const { return best_.cost - kBoundRounding * std::abs(best_.cost); }
    std::optional<std::size_t> branchLink(const Node& node, const OneTree& tree) const;
    void takeTour(const OneTree& tree);
    /// Bounds the node anew; the link to branch on, or none where nothing in it is better.
    std::optional<std::size_t> opened(Node& node, const JobContext& job);

    const LinkCosts& costs_;
    FoundOrder best_;
    const OrderBound& bound_;
    std::vector<UndirectedLink> links_;
    std::vector<double> begin_;
    std::vector<double> finish_;
};

/// The order along a tree that is a tour, driven in the cheaper direction.
void BranchAndBound::takeTour(const OneTree& tree) {
    std::vector<SwathEnd> partner(costs_.endCount(), std::numeric_limits<SwathEnd>::max());
    for (const std::size_t i : tree.links) {
        partner[links_[i].a] = links_[i].b;
        partner[links_[i].b] = links_[i].a;
    }
    EndOrder order;
    for (SwathEnd entered = tree.first; order.size() < costs_.swathCount();
         entered = partner[otherEnd(entered)]) {
        order.push_back(entered);
    }
    EndOrder backwards{order.rbegin(), order.rend()};
    std::ranges::transform(backwards, backwards.begin(), otherEnd);
    for (EndOrder* const each : {&order, &backwards}) {
        if (const double cost = costs_.of(*each); cost < closedAt()) {
            best_ = {std::move(*each), cost};
        }
    }
}

/// A link of the tree that is not taken yet, at the end with the most links.
std::optional<std::size_t> BranchAndBound::branchLink(const Node& node, const OneTree& tree) const {
    std::optional<std::size_t> chosen;
    int most = 0;
    for (const std::size_t i : tree.links) {
        const int degree = std::max(tree.degrees[links_[i].a], tree.degrees[links_[i].b]);
        if (degree > most && !std::ranges::contains(node.taken, i)) {
            most = degree;
            chosen = i;
        }
    }
    return chosen;
}

std::optional<std::size_t> BranchAndBound::opened(Node& node, const JobContext& job) {
    std::vector<UndirectedLink> links = links_;
    std::vector<double> begin = begin_;
    std::vector<double> finish = finish_;
    std::vector<char> isUsed(costs_.endCount(), 0);
    for (const std::size_t i : node.taken) {
        isUsed[links_[i].a] = 1;
        isUsed[links_[i].b] = 1;
    }
    for (UndirectedLink& link : links) {
        if (isUsed[link.a] != 0 || isUsed[link.b] != 0) {
            link.cost = kInfinite;
        }
    }
    for (const std::size_t i : node.taken) {
        links[i].cost = links_[i].cost;
    }
    for (const std::size_t i : node.forbidden) {
        links[i].cost = kInfinite;
    }
    for (SwathEnd end = 0; end < costs_.endCount(); ++end) {
        if (isUsed[end] != 0) {
            begin[end] = kInfinite;
            finish[end] = kInfinite;
        }
    }
    OneTreeFinder finder{
        {.swathCount = costs_.swathCount(), .links = links, .begin = begin, .finish = finish}};
    const Ascent ascent =
        ascended(finder, node.multipliers, best_.cost, kRoundsInNode, job.withoutProgress());
    if (ascent.bound == kInfinite || ascent.tree.cost == kInfinite) {
        return std::nullopt;
    }
    node.bound = std::max(node.bound, ascent.bound);
    if (ascent.tree.isTour()) {
        takeTour(ascent.tree);
    }
    if (node.bound >= closedAt()) {
        return std::nullopt;
    }
    node.multipliers = ascent.multipliers;
    return branchLink(node, ascent.tree);
}

ProvedOrder BranchAndBound::run(std::size_t mostNodes, const JobContext& job) {
    std::vector<Node> open{{bound_.cost, bound_.multipliers, {}, {}}};
    ProvedOrder result;
    std::size_t nodes = 0;
    while (!open.empty() && open.front().bound < closedAt() && nodes < mostNodes && !job.stopRequested()) {
        std::ranges::pop_heap(open, HeapOrder{});
        Node node = std::move(open.back());
        open.pop_back();
        ++nodes;
        const auto link = opened(node, job);
        if (link) {
            Node with = node;
            with.taken.push_back(*link);
            node.forbidden.push_back(*link);
            for (Node* const child : {&node, &with}) {
                open.push_back(std::move(*child));
                std::ranges::push_heap(open, HeapOrder{});
            }
        }
    }
    result.found = best_;
    result.bound = best_.cost;
    if (!open.empty() && open.front().bound < closedAt()) {
        result.bound = open.front().bound;
    }
    return result;
}

}  // namespace

FoundOrder cheapestOrder(const LinkCosts& costs) {
    const std::size_t swaths = costs.swathCount();
    const std::size_t ends = costs.endCount();
    if (swaths == 0) {
        return {};
    }
    const std::size_t all = (std::size_t{1} << swaths) - 1;
    // The least cost at which these swaths are done and the last one was entered there.
    std::vector<double> cost((all + 1) * ends, kInfinite);
    std::vector<SwathEnd> before(cost.size(), 0);
    for (SwathEnd end = 0; end < ends; ++end) {
        cost[(std::size_t{1} << end / 2) * ends + end] = costs.begin(end);
    }
    for (std::size_t done = 1; done < all; ++done) {
        for (SwathEnd at = 0; at < ends; ++at) {
            const double here = cost[done * ends + at];
            for (SwathEnd next = 0; here < kInfinite && next < ends; ++next) {
                const std::size_t bit = std::size_t{1} << next / 2;
                if ((done & bit) != 0) {
                    continue;
                }
                const double there = here + costs.link(otherEnd(at), next);
                if (there < cost[(done | bit) * ends + next]) {
                    cost[(done | bit) * ends + next] = there;
                    before[(done | bit) * ends + next] = at;
                }
            }
        }
    }
    FoundOrder found{.order = {}, .cost = kInfinite};
    SwathEnd at = 0;
    for (SwathEnd end = 0; end < ends; ++end) {
        if (const double whole = cost[all * ends + end] + costs.finish(otherEnd(end)); whole < found.cost) {
            found.cost = whole;
            at = end;
        }
    }
    for (std::size_t done = all; done != 0;) {
        found.order.push_back(at);
        const SwathEnd previous = before[done * ends + at];
        done &= ~(std::size_t{1} << at / 2);
        at = previous;
    }
    std::ranges::reverse(found.order);
    return found;
}

ProvedOrder branchAndBound(const LinkCosts& costs, const FoundOrder& known, const OrderBound& bound,
                           std::size_t mostNodes, const JobContext& job) {
    if (costs.swathCount() < 2) {
        return {.found = known, .bound = known.cost};
    }
    return BranchAndBound{costs, known, bound}.run(mostNodes, job);
}

}  // namespace furrow
