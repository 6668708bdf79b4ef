#include "planner/swaths/edge_tree.h"

#include <numbers>

namespace furrow {

namespace {

// Edges in a leaf: about as dear to look at as another node.
constexpr std::uint32_t kEdgesInLeaf = 4;
// Rounding of a height, as a share of the largest coordinate.
constexpr double kRounding = 1e-14;
// Edges nearer to level than this, in radians, are looked at one by one.
constexpr double kNearlyLevel = 1e-6;
constexpr double kNoCone = 2.0;

}  // namespace

EdgeTree::EdgeTree(const std::vector<Point>& vertices, const std::vector<std::size_t>& ringEnds) {
    double farM = 0.0;
    for (const Point& vertex : vertices) {
        farM = std::max({farM, std::abs(vertex.x), std::abs(vertex.y)});
    }
    slackM_ = kRounding * farM;
    std::size_t begin = 0;
    for (const std::size_t end : ringEnds) {
        if (end > begin) {
            const auto last = static_cast<std::uint32_t>(end);
            roots_.push_back(
                add(vertices, {.before = last - 1, .first = static_cast<std::uint32_t>(begin), .end = last})
                    .node);
        }
        begin = end;
    }
}

EdgeTree::Cone EdgeTree::around(const Cone& a, const Cone& b) {
    if (a.isEmpty() || b.isEmpty()) {
        return a.isEmpty() ? b : a;
    }
    const double between = std::remainder(b.middle - a.middle, 2.0 * std::numbers::pi);
    const double low = std::min(-a.spread, between - b.spread);
    const double high = std::max(a.spread, between + b.spread);
    return {.middle = a.middle + 0.5 * (low + high), .spread = 0.5 * (high - low)};
}

EdgeTree::Added EdgeTree::add(const std::vector<Point>& vertices, const Run& run) {
    Point low = vertices[run.before];
    Point high = low;
    for (std::uint32_t i = run.first; i < run.end; ++i) {
        low = {std::min(low.x, vertices[i].x), std::min(low.y, vertices[i].y)};
        high = {std::max(high.x, vertices[i].x), std::max(high.y, vertices[i].y)};
    }
    Added added{.node = static_cast<std::uint32_t>(nodes_.size()), .cone = {}};
    nodes_.push_back({.middle = 0.5 * (low + high), .half = 0.5 * (high - low), .axis = {}, .run = run});
    if (run.size() > kEdgesInLeaf) {
        const std::uint32_t middle = run.first + run.size() / 2;
        const Added left = add(vertices, {.before = run.before, .first = run.first, .end = middle});
        const Added right = add(vertices, {.before = middle - 1, .first = middle, .end = run.end});
        nodes_[added.node].right = right.node;
        added.cone = around(left.cone, right.cone);
    } else {
        for (std::uint32_t i = 0; i < run.size(); ++i) {
            const Point edge = vertices[run.vertex(i + 1)] - vertices[run.vertex(i)];
            if (edge.x != 0.0 || edge.y != 0.0) {
                added.cone = around(added.cone, {.middle = std::atan2(edge.y, edge.x), .spread = 0.0});
            }
        }
    }
    const double spread = added.cone.spread + kNearlyLevel;
    Node& node = nodes_[added.node];
    node.axis = direction(added.cone.middle);
    node.spreadSine = spread < 0.5 * std::numbers::pi ? std::sin(spread) : kNoCone;
    return added;
}

double EdgeTree::highest(const std::vector<Point>& vertices, double cosine, double sine) const {
    double highest = -std::numeric_limits<double>::infinity();
    forEachRoot([&](std::uint32_t root) {
        std::array<std::uint32_t, kMostDepth> open{root};
        for (std::size_t count = 1; count > 0;) {
            const std::uint32_t at = open[--count];
            const Node& node = nodes_[at];
            if (heights(node, cosine, sine).high < highest) {
                continue;
            }
            if (node.right == 0) {
                for (std::uint32_t i = node.run.first; i < node.run.end; ++i) {
                    highest = std::max(highest, cosine * vertices[i].y - sine * vertices[i].x);
                }
                continue;
            }
            // The higher one comes first.
            const bool leftIsHigher =
                heights(nodes_[at + 1], cosine, sine).high > heights(nodes_[node.right], cosine, sine).high;
            open[count++] = leftIsHigher ? node.right : at + 1;
            open[count++] = leftIsHigher ? at + 1 : node.right;
        }
    });
    return highest;
}

}  // namespace furrow
