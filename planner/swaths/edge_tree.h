#pragma once

#include "planner/geometry/point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace furrow {

/// A tree over the edges of rings. Each node is a run of edges that follow on each other, with the box around
/// them. A line that crosses k edges of n is found in O(k log n). Immutable; thread-safe.
class EdgeTree {
public:
    EdgeTree() = default;
    /// @param vertices  rings one after the other; not kept
    /// @param ringEnds  one past the last vertex of each ring
    EdgeTree(const std::vector<Point>& vertices, const std::vector<std::size_t>& ringEnds);

    bool empty() const { return nodes_.empty(); }

    /// The largest cosine * y - sine * x of all vertices. O(log n) on average.
    double highest(const std::vector<Point>& vertices, double cosine, double sine) const;

    /// Calls visit(from, to) with the vertices of every edge of the runs whose height range may matter, where
    /// heights are as in `highest`.
    /// @param mayMatter  (low, high) of a run, a little wider than it is
    template <class MayMatter, class Visit>
    void visitEdges(double cosine, double sine, const MayMatter& mayMatter, const Visit& visit) const {
        if (nodes_.empty()) {
            return;
        }
        forEachRoot([&](std::uint32_t root) {
            std::array<std::uint32_t, kMostDepth> open{root};
            for (std::size_t count = 1; count > 0;) {
                const std::uint32_t at = open[--count];
                const Node& node = nodes_[at];
                const auto [low, high] = heights(node, cosine, sine);
                if (!mayMatter(low, high)) {
                    continue;
                }
                if (node.right == 0) {
                    std::uint32_t from = node.before;
                    for (std::uint32_t to = node.first; to < node.end; from = to++) {
                        visit(from, to);
                    }
                } else {
                    open[count++] = node.right;
                    open[count++] = at + 1;
                }
            }
        });
    }

private:
    static constexpr std::size_t kMostDepth = 64;

    struct Node {
        Point middle;
        Point half;                ///< of the box
        std::uint32_t before = 0;  ///< the vertex at which the first edge begins
        std::uint32_t first = 0;   ///< vertices at which edges end
        std::uint32_t end = 0;
        std::uint32_t right = 0;  ///< child; the left one follows the node; 0 for a leaf
    };
    struct Heights {
        double low = 0.0;
        double high = 0.0;
    };

    std::uint32_t add(const std::vector<Point>& vertices, std::uint32_t before, std::uint32_t first,
                      std::uint32_t end);
    Heights heights(const Node& node, double cosine, double sine) const {
        const double middle = cosine * node.middle.y - sine * node.middle.x;
        const double half = std::abs(cosine) * node.half.y + std::abs(sine) * node.half.x + slackM_;
        return {middle - half, middle + half};
    }
    template <class Visit>
    void forEachRoot(const Visit& visit) const {
        for (const std::uint32_t root : roots_) {
            visit(root);
        }
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> roots_;  ///< one for each ring
    double slackM_ = 0.0;               ///< against rounding
};

}  // namespace furrow
