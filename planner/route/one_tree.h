#pragma once

#include "planner/route/link_costs.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace furrow {

/// The cost of what cannot be driven.
inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A link between the ends of two swaths, in either direction of driving.
struct UndirectedLink {
    SwathEnd a = 0;  ///< the lower one
    SwathEnd b = 0;
    double cost = 0.0;
};

/// A least tree over the swaths, and the two cheapest links of a depot to different ends: every order of the
/// swaths is one of these, in which every end has one link.
struct OneTree {
    double cost = 0.0;  ///< with the multipliers added to its links and taken off once for every end
    std::vector<std::size_t> links;  ///< indices of the links of the tree, by weight
    SwathEnd first = 0;              ///< where the depot's way in arrives
    SwathEnd last = 0;               ///< where its way out begins
    std::vector<int> degrees;        ///< links at every end
    double squaredError = 0.0;       ///< sum of (degree - 1)² over the ends
    bool isTour() const { return squaredError == 0.0; }
};

/// The links that trees are made from. Those of infinite cost are left out.
struct OneTreeTask {
    std::size_t swathCount = 0;  ///< one at the least
    std::span<const UndirectedLink> links;
    std::span<const double> begin;   ///< cost of the depot's way to each end
    std::span<const double> finish;  ///< cost of its way from each end
};

/// Least trees for one set of links after another set of multipliers. Source: Held & Karp 1971,
/// doi 10.1007/BF01584070, with each swath contracted to one node.
class OneTreeFinder {
public:
    explicit OneTreeFinder(const OneTreeTask& task);

    /// Of infinite cost if the links do not join all swaths. Cost: O(links + swaths²).
    const OneTree& find(std::span<const double> multipliers);

private:
    static constexpr std::size_t kNoLink = std::numeric_limits<std::size_t>::max();

    /// A link beside a swath, and the swath that it leads to.
    struct Beside {
        std::size_t swath = 0;
        std::size_t link = 0;
    };
    /// The least link from the tree to a swath.
    struct Nearest {
        double weight = kInfinite;
        std::size_t link = kNoLink;
        bool isIn = false;

        bool isAfter(double otherWeight, std::size_t otherLink) const {
            return otherWeight < weight || (otherWeight == weight && otherLink < link);
        }
    };

    void pickLinks();
    void addDepot(std::span<const double> multipliers);

    OneTreeTask task_;
    OneTree tree_;
    std::vector<double> weights_;
    std::vector<std::size_t> firstBeside_;  ///< of each swath, in `beside_`; one more for the end
    std::vector<Beside> beside_;
    std::vector<Nearest> nearest_;
    std::vector<std::size_t> lacked_;  ///< swaths outside the tree, in no order
};

/// Multipliers and the bound that they prove.
struct Ascent {
    double bound = -std::numeric_limits<double>::infinity();
    std::vector<double> multipliers;
    OneTree tree;  ///< at these multipliers
};

/// Moves multipliers along the subgradient with momentum to raise the bound.
/// @param known  the cost of some order; the ascent ends where the bound reaches it
Ascent ascended(OneTreeFinder& finder, std::vector<double> multipliers, double known, std::size_t rounds,
                const JobContext& job);

}  // namespace furrow
