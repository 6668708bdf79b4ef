#include "ui/map/even_odd_fill.h"

#include <algorithm>
#include <cstdint>

namespace furrow {

namespace {

struct FillEdge {
    MapPoint top;
    MapPoint bottom;

    double xAt(double y) const {
        const double share = (y - double{top.y}) / (double{bottom.y} - double{top.y});
        return double{top.x} + share * (double{bottom.x} - double{top.x});
    }
};

struct Strip {
    std::uint32_t left;
    std::uint32_t right;
    float top;
};

std::vector<FillEdge> edgesFromTop(const std::vector<std::vector<MapPoint>>& rings) {
    std::vector<FillEdge> edges;
    for (const auto& ring : rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            MapPoint a = ring[i];
            MapPoint b = ring[i + 1 == ring.size() ? 0 : i + 1];
            if (a.y > b.y) {
                std::swap(a, b);
            }
            if (a.y < b.y) {
                edges.push_back({a, b});
            }
        }
    }
    std::ranges::sort(edges, {}, [](const FillEdge& edge) { return edge.top.y; });
    return edges;
}

/// Where edges begin or end, each once, from the top.
std::vector<float> heightsOf(const std::vector<FillEdge>& edges) {
    std::vector<float> heights;
    for (const FillEdge& edge : edges) {
        heights.push_back(edge.top.y);
        heights.push_back(edge.bottom.y);
    }
    std::ranges::sort(heights);
    heights.erase(std::ranges::unique(heights).begin(), heights.end());
    return heights;
}

/// Sorts the active edges by where they are at a height; `places` are these, and room for them. Nearly sorted
/// from the band above, so insertion is the fastest way.
void sortAt(double height, const std::vector<FillEdge>& edges, std::vector<std::uint32_t>& active,
            std::vector<double>& places) {
    places.resize(active.size());
    for (std::size_t k = 0; k < active.size(); ++k) {
        const std::uint32_t edge = active[k];
        const double x = edges[edge].xAt(height);
        std::size_t slot = k;
        for (; slot > 0 && places[slot - 1] > x; --slot) {
            places[slot] = places[slot - 1];
            active[slot] = active[slot - 1];
        }
        places[slot] = x;
        active[slot] = edge;
    }
}

void addTrapezoid(FillMesh& mesh, const FillEdge& left, const FillEdge& right, float top, float bottom) {
    const auto at = [](const FillEdge& edge, float y) {
        return MapPoint{static_cast<float>(edge.xAt(double{y})), y};
    };
    const MapPoint a = at(left, top);
    const MapPoint b = at(right, top);
    const MapPoint c = at(left, bottom);
    const MapPoint d = at(right, bottom);
    mesh.insert(mesh.end(), {a, b, c, b, d, c});
}

}  // namespace

FillMesh evenOddTriangles(const std::vector<std::vector<MapPoint>>& rings) {
    const std::vector<FillEdge> edges = edgesFromTop(rings);
    const std::vector<float> heights = heightsOf(edges);
    FillMesh mesh;
    std::vector<std::uint32_t> active;  // from left to right
    std::vector<double> middles;
    std::vector<Strip> open;
    std::vector<Strip> next;
    std::uint32_t upcoming = 0;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const float top = heights[i];
        const double middle = (double{top} + double{heights[i + 1]}) / 2.0;
        std::erase_if(active, [&](std::uint32_t edge) { return edges[edge].bottom.y <= top; });
        for (; upcoming < edges.size() && edges[upcoming].top.y <= top; ++upcoming) {
            active.push_back(upcoming);
        }
        sortAt(middle, edges, active, middles);
        next.clear();
        std::size_t from = 0;
        for (std::size_t k = 0; k + 1 < active.size(); k += 2) {
            const std::uint32_t left = active[k];
            const std::uint32_t right = active[k + 1];
            const auto same =
                std::find_if(open.begin() + static_cast<std::ptrdiff_t>(from), open.end(),
                             [&](const Strip& s) { return s.left == left && s.right == right; });
            if (same == open.end()) {
                next.push_back({left, right, top});
                continue;
            }
            // Strips keep their order, so those passed over end here.
            const auto index = static_cast<std::size_t>(same - open.begin());
            for (; from < index; ++from) {
                addTrapezoid(mesh, edges[open[from].left], edges[open[from].right], open[from].top, top);
            }
            next.push_back(*same);
            from = index + 1;
        }
        for (; from < open.size(); ++from) {
            addTrapezoid(mesh, edges[open[from].left], edges[open[from].right], open[from].top, top);
        }
        std::swap(open, next);
    }
    for (const Strip& strip : open) {
        addTrapezoid(mesh, edges[strip.left], edges[strip.right], strip.top, heights.back());
    }
    return mesh;
}

}  // namespace furrow
