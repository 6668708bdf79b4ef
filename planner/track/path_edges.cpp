#include "planner/track/path_edges.h"

namespace furrow {

namespace {

// A sample this far before the start or behind the end is not on the path.
constexpr double kBeyondEndM = 0.5;

}  // namespace

std::vector<PathEdge> edgesOf(const Path& path) {
    std::vector<PathEdge> edges;
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        const std::vector<PathSample>& samples = path.segments[i].samples;
        for (std::size_t k = 1; k < samples.size(); ++k) {
            const Point step = samples[k].position - samples[k - 1].position;
            const double length = norm(step);
            if (length > 0.0 && std::isfinite(length)) {
                edges.push_back({.from = samples[k - 1].position,
                                 .along = (1.0 / length) * step,
                                 .lengthM = length,
                                 .sM = samples[k - 1].sM,
                                 .sPerM = (samples[k].sM - samples[k - 1].sM) / length,
                                 .segment = static_cast<std::uint32_t>(i)});
            }
        }
    }
    if (!edges.empty()) {
        edges.front().first = true;
        edges.back().last = true;
    }
    return edges;
}

Foot footOn(const PathEdge& edge, Point place) {
    const Point from = place - edge.from;
    const double along = dot(from, edge.along);
    if ((edge.first && along < -kBeyondEndM) || (edge.last && along > edge.lengthM + kBeyondEndM)) {
        return {};
    }
    const double clamped = std::clamp(along, 0.0, edge.lengthM);
    return {clamped, norm(from - clamped * edge.along)};
}

PathEdgeGrid::PathEdgeGrid(std::span<const PathEdge> edges, double radiusM) {
    Point high;
    for (const PathEdge& edge : edges) {
        const Point to = edge.from + edge.lengthM * edge.along;
        const bool first = &edge == &edges.front();
        low_ = first ? edge.from : low_;
        high = first ? edge.from : high;
        low_ = {std::min({low_.x, edge.from.x, to.x}), std::min({low_.y, edge.from.y, to.y})};
        high = {std::max({high.x, edge.from.x, to.x}), std::max({high.y, edge.from.y, to.y})};
    }
    // Not more cells than memory allows on a path of hundreds of kilometres.
    constexpr double kMostCells = 4e6;
    const Point size = high - low_;
    cellM_ = std::max({kCellOfRadius * radiusM, std::sqrt(size.x * size.y / kMostCells),
                       std::max(size.x, size.y) / kMostCells});
    columns_ = static_cast<std::size_t>(size.x / cellM_) + 1;
    rows_ = static_cast<std::size_t>(size.y / cellM_) + 1;
    fill(edges);
}

void PathEdgeGrid::fill(std::span<const PathEdge> edges) {
    begin_.assign(columns_ * rows_ + 1, 0);
    for (const PathEdge& edge : edges) {
        walk(edge, [this](std::size_t cell) { ++begin_[cell + 1]; });
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) {
        begin_[i] += begin_[i - 1];
    }
    entries_.resize(begin_.back());
    std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        walk(edges[i], [&](std::size_t cell) { entries_[next[cell]++] = static_cast<std::uint32_t>(i); });
    }
}

}  // namespace furrow
