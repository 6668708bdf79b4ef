#include "planner/route/order_bound.h"

#include "planner/route/one_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace furrow {

namespace {

// How often links that the tree lacked are added, and its own ones are checked.
constexpr int kMostPricings = 12;
constexpr std::size_t kLaterShare = 6;
// Of the progress.
constexpr double kFirstPricing = 0.7;
constexpr double kEqual = 1e-9;

/// Links of trees, each once.
class LinkSet {
public:
    explicit LinkSet(const LinkCosts& costs) : costs_{costs} {}

    void add(SwathEnd a, SwathEnd b) {
        const auto [low, high] = std::minmax(a, b);
        if (a / 2 != b / 2 && known_.emplace(low, high).second) {
            links_.push_back({low, high, costs_.eitherWay(low, high)});
        }
    }
    const std::vector<UndirectedLink>& links() const { return links_; }
    void lookUpAgain() {
        for (UndirectedLink& link : links_) {
            link.cost = costs_.eitherWay(link.a, link.b);
        }
    }

private:
    const LinkCosts& costs_;
    std::set<std::pair<SwathEnd, SwathEnd>> known_;
    std::vector<UndirectedLink> links_;
};

/// The least tree over all pairs of ends by their lower bounds (Prim 1957).
struct FullTree {
    double cost = 0.0;
    std::vector<std::pair<SwathEnd, SwathEnd>> links;
};

FullTree fullTree(const LinkCosts& costs, const std::vector<double>& multipliers) {
    const std::size_t swaths = costs.swathCount();
    struct Nearest {
        double weight = kInfinite;
        SwathEnd from = 0;
        SwathEnd to = 0;
    };
    std::vector<Nearest> nearest(swaths);
    std::vector<char> isIn(swaths, 0);
    FullTree tree;
    std::size_t added = 0;
    for (std::size_t step = 1; step < swaths; ++step) {
        isIn[added] = 1;
        for (std::size_t swath = 0; swath < swaths; ++swath) {
            for (std::size_t pair = 0; isIn[swath] == 0 && pair < 4; ++pair) {
                const auto from = static_cast<SwathEnd>(2 * added + pair / 2);
                const auto to = static_cast<SwathEnd>(2 * swath + pair % 2);
                const double weight = costs.atLeast(from, to) + multipliers[from] + multipliers[to];
                if (weight < nearest[swath].weight) {
                    nearest[swath] = {weight, from, to};
                }
            }
        }
        added = swaths;
        for (std::size_t swath = 0; swath < swaths; ++swath) {
            if (isIn[swath] == 0 && (added == swaths || nearest[swath].weight < nearest[added].weight)) {
                added = swath;
            }
        }
        tree.cost += nearest[added].weight;
        tree.links.emplace_back(nearest[added].from, nearest[added].to);
    }
    return tree;
}

/// The weight of the dearest link of a tree between any two swaths, row by row.
std::vector<double> dearestBetween(const FullTree& tree, const LinkCosts& costs,
                                   const std::vector<double>& multipliers) {
    const std::size_t swaths = costs.swathCount();
    std::vector<double> dearest(swaths * swaths, 0.0);
    // A link leads from the swaths that are joined already to one that is not.
    std::vector<std::size_t> joined{tree.links.empty() ? 0 : tree.links.front().first / 2};
    for (const auto& [from, to] : tree.links) {
        const double weight = costs.atLeast(from, to) + multipliers[from] + multipliers[to];
        for (const std::size_t other : joined) {
            const double between =
                other == from / 2 ? weight : std::max(weight, dearest[other * swaths + from / 2]);
            dearest[other * swaths + to / 2] = between;
            dearest[to / 2 * swaths + other] = between;
        }
        joined.push_back(to / 2);
    }
    return dearest;
}

/// The cost of the depot's two links in a tree, with the multipliers of all ends taken off.
double depotCost(const OneTree& tree, const std::vector<UndirectedLink>& links,
                 const std::vector<double>& multipliers) {
    double rest = tree.cost;
    for (const std::size_t i : tree.links) {
        rest -= links[i].cost + multipliers[links[i].a] + multipliers[links[i].b];
    }
    return rest;
}

}  // namespace

OrderBound heldKarpBound(LinkCosts& costs, const NearEnds& near, double known, std::size_t rounds,
                         const JobContext& job) {
    const std::size_t ends = costs.endCount();
    OrderBound bound{.cost = 0.0, .multipliers = std::vector<double>(ends, 0.0)};
    if (costs.swathCount() == 0) {
        return bound;
    }
    std::vector<double> begin(ends);
    std::vector<double> finish(ends);
    for (SwathEnd end = 0; end < ends; ++end) {
        begin[end] = costs.begin(end);
        finish[end] = costs.finish(end);
    }
    LinkSet links{costs};
    for (SwathEnd end = 0; end < ends; ++end) {
        for (const SwathEnd other : near.enteredFrom[end]) {
            links.add(end, other);
        }
        for (const SwathEnd other : near.leftBefore[end]) {
            links.add(end, other);
        }
    }
    bound.cost = -kInfinite;
    std::vector<double> multipliers = bound.multipliers;
    for (int pricing = 0; pricing < kMostPricings; ++pricing) {
        // Links of the least tree over all pairs join what the near ones do not.
        FullTree full = fullTree(costs, multipliers);
        for (const auto& [a, b] : full.links) {
            links.add(a, b);
        }
        OneTreeFinder finder{
            {.swathCount = costs.swathCount(), .links = links.links(), .begin = begin, .finish = finish}};
        const auto begun = [](int pricings) {
            return pricings == 0
                       ? 0.0
                       : kFirstPricing + (1.0 - kFirstPricing) * (pricings - 1) / (kMostPricings - 1);
        };
        const Ascent ascent =
            ascended(finder, multipliers, known, pricing == 0 ? rounds : rounds / kLaterShare,
                     job.part(begun(pricing), begun(pricing + 1)));
        multipliers = ascent.multipliers;
        full = fullTree(costs, multipliers);
        const double proved = full.cost + depotCost(ascent.tree, links.links(), multipliers);
        if (proved > bound.cost) {
            bound = {proved, multipliers};
        }
        bool isDearer = false;
        for (const std::size_t i : ascent.tree.links) {
            const UndirectedLink& link = links.links()[i];
            isDearer = costs.check(link.a, link.b) || isDearer;
            isDearer = costs.check(link.b, link.a) || isDearer;
        }
        if ((!isDearer && ascent.bound - proved <= kEqual * std::abs(known)) || job.stopRequested()) {
            break;
        }
        links.lookUpAgain();
    }
    bound.cost = std::min(bound.cost, known);
    return bound;
}

std::vector<UndirectedLink> linksOfCheaperOrders(const LinkCosts& costs, const OrderBound& bound,
                                                 double known) {
    const std::vector<double> dearest =
        dearestBetween(fullTree(costs, bound.multipliers), costs, bound.multipliers);
    const double most = known + kEqual * std::abs(known) - bound.cost;
    std::vector<UndirectedLink> links;
    const auto ends = static_cast<SwathEnd>(costs.endCount());
    for (SwathEnd a = 0; a < ends; ++a) {
        for (SwathEnd b = a + 1; b < ends; ++b) {
            if (a / 2 == b / 2) {
                continue;
            }
            const double saved =
                dearest[a / 2 * costs.swathCount() + b / 2] - bound.multipliers[a] - bound.multipliers[b];
            if (costs.atLeast(a, b) - saved > most) {
                continue;
            }
            if (const double cost = costs.eitherWay(a, b); cost - saved <= most) {
                links.push_back({a, b, cost});
            }
        }
    }
    return links;
}

double assignmentBound(const LinkCosts& costs) {
    // Swaths and the depot, the last one; from each to another one, by whichever ends are the cheapest.
    const std::size_t swaths = costs.swathCount();
    const std::size_t nodes = swaths + 1;
    std::vector<double> cost(nodes * nodes, kInfinite);
    for (std::size_t from = 0; from < nodes; ++from) {
        for (std::size_t to = 0; to < nodes; ++to) {
            double& least = cost[from * nodes + to];
            for (SwathEnd side = 0; from != to && side < 4; ++side) {
                const auto leaving = static_cast<SwathEnd>(2 * from + side / 2);
                const auto entered = static_cast<SwathEnd>(2 * to + side % 2);
                least = std::min(least, from == swaths ? costs.begin(entered)
                                        : to == swaths ? costs.finish(leaving)
                                                       : costs.link(leaving, entered));
            }
        }
    }
    // The Hungarian method by shortest augmenting paths; node 0 of each side stands for none.
    std::vector<double> rowPrice(nodes + 1, 0.0);
    std::vector<double> columnPrice(nodes + 1, 0.0);
    std::vector<std::size_t> rowOf(nodes + 1, 0);
    std::vector<std::size_t> before(nodes + 1, 0);
    for (std::size_t row = 1; row <= nodes; ++row) {
        rowOf[0] = row;
        std::size_t column = 0;
        std::vector<double> slack(nodes + 1, kInfinite);
        std::vector<char> isDone(nodes + 1, 0);
        while (rowOf[column] != 0) {
            isDone[column] = 1;
            const std::size_t at = rowOf[column];
            double least = kInfinite;
            std::size_t next = 0;
            for (std::size_t other = 1; other <= nodes; ++other) {
                if (isDone[other] != 0) {
                    continue;
                }
                const double reduced = cost[(at - 1) * nodes + other - 1] - rowPrice[at] - columnPrice[other];
                if (reduced < slack[other]) {
                    slack[other] = reduced;
                    before[other] = column;
                }
                if (slack[other] < least) {
                    least = slack[other];
                    next = other;
                }
            }
            if (next == 0) {
                return 0.0;
            }
            for (std::size_t other = 0; other <= nodes; ++other) {
                if (isDone[other] != 0) {
                    rowPrice[rowOf[other]] += least;
                    columnPrice[other] -= least;
                } else {
                    slack[other] -= least;
                }
            }
            column = next;
        }
        while (column != 0) {
            rowOf[column] = rowOf[before[column]];
            column = before[column];
        }
    }
    double sum = 0.0;
    for (std::size_t column = 1; column <= nodes; ++column) {
        sum += cost[(rowOf[column] - 1) * nodes + column - 1];
    }
    return sum;
}

}  // namespace furrow
