#include "planner/swaths/edge_tree.h"

namespace furrow {

namespace {

// Edges in a leaf: about as dear to look at as another node.
constexpr std::uint32_t kEdgesInLeaf = 4;
// Rounding of a height, as a share of the largest coordinate.
constexpr double kRounding = 1e-14;

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
            roots_.push_back(add(vertices, static_cast<std::uint32_t>(end - 1),
                                 static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)));
        }
        begin = end;
    }
}

std::uint32_t EdgeTree::add(const std::vector<Point>& vertices, std::uint32_t before, std::uint32_t first,
                            std::uint32_t end) {
    Point low = vertices[before];
    Point high = low;
    for (std::uint32_t i = first; i < end; ++i) {
        low = {std::min(low.x, vertices[i].x), std::min(low.y, vertices[i].y)};
        high = {std::max(high.x, vertices[i].x), std::max(high.y, vertices[i].y)};
    }
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.middle = 0.5 * (low + high),
                      .half = 0.5 * (high - low),
                      .before = before,
                      .first = first,
                      .end = end});
    if (end - first > kEdgesInLeaf) {
        const std::uint32_t middle = first + (end - first) / 2;
        add(vertices, before, first, middle);
        nodes_[node].right = add(vertices, middle - 1, middle, end);
    }
    return node;
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
                for (std::uint32_t i = node.first; i < node.end; ++i) {
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
