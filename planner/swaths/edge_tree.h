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
/// them and the cone of their directions. Immutable; thread-safe.
class EdgeTree {
public:
    enum class Trend { Falls, Rises, Mixed };
    /// Edges that follow on each other.
    struct Run {
        std::uint32_t before = 0;  ///< the vertex at which the first edge begins
        std::uint32_t first = 0;   ///< vertices at which edges end
        std::uint32_t end = 0;

        std::uint32_t size() const { return end - first; }
        /// The i-th vertex, of 0 to size().
        std::uint32_t vertex(std::uint32_t i) const { return i == 0 ? before : first + i - 1; }
    };

    EdgeTree() = default;
    /// @param vertices  rings one after the other; not kept
    /// @param ringEnds  one past the last vertex of each ring
    EdgeTree(const std::vector<Point>& vertices, const std::vector<std::size_t>& ringEnds);

    bool empty() const { return nodes_.empty(); }

    /// The largest cosine * y - sine * x of all vertices. O(log n) on average.
    double highest(const std::vector<Point>& vertices, double cosine, double sine) const;

    /// Calls visit(run, trend) with runs whose height range may matter, ring by ring and in their order,
    /// where heights are as in `highest`: runs that rise or fall all along, and short ones for the rest. O(t
    /// log n) for t places at which the outline turns up or down.
    /// @param mayMatter  (low, high) of a run, a little wider than it is
    template <class MayMatter, class Visit>
    void visitRuns(double cosine, double sine, const MayMatter& mayMatter, const Visit& visit) const {
        forEachRoot([&](std::uint32_t root) {
            std::array<std::uint32_t, kMostDepth> open{root};
            for (std::size_t count = 1; count > 0;) {
                const std::uint32_t at = open[--count];
                const Node& node = nodes_[at];
                const auto [low, high] = heights(node, cosine, sine);
                if (!mayMatter(low, high)) {
                    continue;
                }
                const Trend trend = node.trend(cosine, sine);
                if (trend != Trend::Mixed || node.right == 0) {
                    visit(node.run, trend);
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
        Point half;               ///< of the box
        Point axis;               ///< of the directions
        double spreadSine = 0.0;  ///< of the angle to the axis; more than 1 where there is no cone
        Run run;
        std::uint32_t right = 0;  ///< child; the left one follows the node; 0 for a leaf

        Trend trend(double cosine, double sine) const {
            const double slope = cosine * axis.y - sine * axis.x;
            return slope > spreadSine ? Trend::Rises : slope < -spreadSine ? Trend::Falls : Trend::Mixed;
        }
    };
    /// Directions up to `spread` to both sides of `middle`, in radians.
    struct Cone {
        double middle = 0.0;
        double spread = -1.0;  ///< less than 0 for none

        bool isEmpty() const { return spread < 0.0; }
    };
    struct Added {
        std::uint32_t node = 0;
        Cone cone;
    };
    struct Heights {
        double low = 0.0;
        double high = 0.0;
    };

    static Cone around(const Cone& a, const Cone& b);
    Added add(const std::vector<Point>& vertices, const Run& run);
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
